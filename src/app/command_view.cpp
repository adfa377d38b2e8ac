#include <cstdio>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "app/commands.hpp"
#include "app/open_browser.hpp"
#include "base/error.hpp"
#include "io/output/view_page.hpp"
#include "io/web/view_server.hpp"
#include "run/view.hpp"

namespace sabo {
namespace {

struct ViewOptions {
  std::string folder;
  std::string other;
  std::optional<int> port;
  bool has_no_browser = false;
};

int show(const ViewOptions& options) {
  ServedView view;
  view.folder = view_of_run(options.folder);
  if (!options.other.empty()) view.other = view_of_run(options.other);
  view.page = view_page();
  view.policy = view_page_policy();
  ViewServer server(view, options.port);
  fmt::print("The view of {} is at\n\n  {}\n\nfor this machine only, until Ctrl-C.\n",
             options.folder, server.address());
  std::fflush(stdout);
  if (!options.has_no_browser) open_browser(server.address());
  server.serve();
  return exit_done;
}

}  // namespace

void add_view_command(CLI::App& program, Action& action) {
  CLI::App* command =
      program.add_subcommand("view", "Show a run in 3D in a browser, alone or beside another run");
  const auto options = std::make_shared<ViewOptions>();
  command->add_option("DIR", options->folder, "folder of a run")->required()->type_name("");
  command
      ->add_option("--with", options->other,
                   "folder of another run to compare with, e.g. without the dam")
      ->type_name("DIR");
  command
      ->add_option("--port", options->port, "port on 127.0.0.1; default: 8642, or any that is free")
      ->check(CLI::Range(1, 65535))
      ->type_name("N");
  command->add_flag("--no-browser", options->has_no_browser, "print the address only");
  command->footer(
      "Nothing but the view is served, to this machine alone. The view also opens without\n"
      "this command: DIR/view/index.html.\n\n"
      "Examples:\n  sabo view demo-run\n  sabo view with-dam --with without-dam");
  command->callback([&action, options] { action = {"", [options] { return show(*options); }}; });
}

}  // namespace sabo
