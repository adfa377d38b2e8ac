#include "io/web/view_server.hpp"

#include <algorithm>
#include <atomic>
#include <system_error>
#include <utility>

#include <fmt/format.h>
#include <httplib.h>

#include "base/error.hpp"
#include "io/output/read_file.hpp"

namespace sabo {
namespace {

namespace fs = std::filesystem;

constexpr const char* loopback = "127.0.0.1";
constexpr int usual_port = 8642;
constexpr std::size_t largest_file = std::size_t{1} << 31;  // bytes
constexpr std::size_t threads = 8;  // a browser opens six connections at a time

/// A file of view/ with a plain name; nothing for a link or another kind of file.
std::optional<std::string> plain_file(const fs::path& folder, const std::string& name) {
  std::error_code error;
  const fs::path file = folder / name;
  if (fs::symlink_status(file, error).type() != fs::file_type::regular) return {};
  return read_file(file, largest_file);
}

void set_headers(httplib::Response& response, std::string_view policy) {
  response.set_header("Content-Security-Policy", std::string(policy));
  response.set_header("X-Content-Type-Options", "nosniff");
  response.set_header("Referrer-Policy", "no-referrer");
  response.set_header("Cross-Origin-Resource-Policy", "same-origin");
  response.set_header("Cross-Origin-Opener-Policy", "same-origin");
  response.set_header("X-Frame-Options", "DENY");
  response.set_header("Cache-Control", "no-store");  // the run may be made again at any time
}

/// Without compression, which would cost more than it saves on the way from here to here.
void send(httplib::Response& response, std::string content, const char* type) {
  const auto kept = std::make_shared<const std::string>(std::move(content));
  response.set_content_provider(
      kept->size(), type, [kept](std::size_t offset, std::size_t length, httplib::DataSink& sink) {
        return sink.write(kept->data() + offset, length);
      });
}

void refuse(httplib::Response& response, int status, const std::string& reason) {
  response.status = status;
  response.set_content(reason + "\n", "text/plain; charset=utf-8");
}

/// Not SO_REUSEPORT, the library's choice, with which two servers would share a port in silence.
void let_port_be_used_again(socket_t socket) {
  const int yes = 1;
  setsockopt(socket, SOL_SOCKET, SO_REUSEADDR, &yes, sizeof yes);
}

void refuse_link(const fs::path& folder) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(folder, error))) return;
  throw CaseError(folder.string(), "is a symbolic link, which may lead out of the run folder",
                  "give a run folder with a folder view of its own");
}

bool names_this_host(const httplib::Request& request, int port) {
  if (request.get_header_value_count("Host") != 1) return false;
  const std::string host = request.get_header_value("Host");
  return host == fmt::format("{}:{}", loopback, port) || host == fmt::format("localhost:{}", port);
}

bool comes_from_another_site(const httplib::Request& request) {
  const std::string site = request.get_header_value("Sec-Fetch-Site");
  return !site.empty() && site != "same-origin" && site != "none";
}

}  // namespace

struct ViewServer::Parts {
  ServedView view;
  int port = 0;
  httplib::Server server;
  std::atomic<bool> is_stopped{false};

  void serve_page() {
    server.Get("/", [this](const httplib::Request&, httplib::Response& response) {
      send(response, std::string(view.page), "text/html; charset=utf-8");
    });
  }

  void serve_folder(const char* prefix, fs::path folder) {
    server.Get(
        fmt::format("{}(scene\\.js|frame_[0-9]{{5,9}}\\.js)", prefix),
        [folder = std::move(folder)](const httplib::Request& request, httplib::Response& response) {
          std::optional<std::string> content = plain_file(folder, request.matches[1]);
          if (!content) return refuse(response, 404, "no such file");
          send(response, std::move(*content), "text/javascript; charset=utf-8");
        });
  }

  httplib::Server::HandlerResponse check(const httplib::Request& request,
                                         httplib::Response& response) const {
    set_headers(response, view.policy);
    if (request.method != "GET" && request.method != "HEAD") {
      response.set_header("Allow", "GET, HEAD");
      refuse(response, 405, "read only");
    } else if (!names_this_host(request, port) || comes_from_another_site(request)) {
      refuse(response, 403, "for this machine only");
    } else {
      return httplib::Server::HandlerResponse::Unhandled;
    }
    return httplib::Server::HandlerResponse::Handled;
  }
};

ViewServer::ViewServer(ServedView view, std::optional<int> port)
    : parts_(std::make_unique<Parts>()) {
  parts_->view = std::move(view);
  refuse_link(parts_->view.folder);
  if (parts_->view.other) refuse_link(*parts_->view.other);
  httplib::Server& server = parts_->server;
  server.set_socket_options(let_port_be_used_again);
  server.new_task_queue = [] { return new httplib::ThreadPool(threads); };
  server.set_payload_max_length(0);
  server.set_keep_alive_max_count(10'000);
  server.set_pre_routing_handler(
      [parts = parts_.get()](const httplib::Request& request, httplib::Response& response) {
        return parts->check(request, response);
      });
  parts_->serve_page();
  parts_->serve_folder("/", parts_->view.folder);
  if (parts_->view.other) parts_->serve_folder("/with/", *parts_->view.other);

  const int wished = port.value_or(usual_port);
  if (server.bind_to_port(loopback, wished)) {
    parts_->port = wished;
  } else if (!port) {
    parts_->port = server.bind_to_any_port(loopback);
  }
  if (parts_->port <= 0) {
    throw CaseError("--port", fmt::format("port {} cannot be used", wished),
                    "give another one, or none to take any that is free");
  }
}

ViewServer::~ViewServer() = default;

std::string ViewServer::address() const {
  return fmt::format("http://{}:{}/{}", loopback, parts_->port,
                     parts_->view.other ? "?with=with/" : "");
}

void ViewServer::serve() {
  const bool is_fine = parts_->server.listen_after_bind();
  if (!is_fine && !parts_->is_stopped) throw RunError("the server has stopped by itself");
}

void ViewServer::stop() {
  parts_->is_stopped = true;
  parts_->server.stop();
}

}  // namespace sabo
