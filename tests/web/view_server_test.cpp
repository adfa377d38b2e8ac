#include "io/web/view_server.hpp"

#include <filesystem>
#include <thread>

#include "support/fault_of.hpp"
#include "support/temporary_folder.hpp"
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <httplib.h>

namespace sabo {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

int port_of(const ViewServer& server) {
  const std::string address = server.address();
  return std::stoi(address.substr(std::string("http://127.0.0.1:").size()));
}

/// A served folder view/ beside a file that must not be seen.
class Server : public testing::Test {
 protected:
  Server() {
    fs::create_directories(folder_ / "run/view");
    fs::create_directories(folder_ / "other/view");
    folder_.write("run/view/scene.js", "first");
    folder_.write("other/view/scene.js", "second");
    folder_.write("run/view/frame_00012.js", "twelve");
    folder_.write("run/view/note.txt", "hidden");
    folder_.write("run/scene.js", "outside");
    folder_.write("run/frame_00001.js", "outside");
    fs::create_symlink(folder_ / "run/scene.js", folder_ / "run/view/frame_00099.js");
    server_ = std::make_unique<ViewServer>(
        ServedView{folder_ / "run/view", folder_ / "other/view", "<p>page", "default-src 'none'"},
        std::nullopt);
    thread_ = std::thread([this] { server_->serve(); });
    client_ = std::make_unique<httplib::Client>("127.0.0.1", port_of(*server_));
    client_->set_url_encode(false);
    while (!client_->Get("/")) std::this_thread::yield();
  }
  ~Server() override {
    server_->stop();
    thread_.join();
  }

  int status_of(const std::string& path, const httplib::Headers& headers = {}) {
    const auto answer = client_->Get(path, headers);
    return answer ? answer->status : -1;
  }
  std::string body_of(const std::string& path) { return client_->Get(path)->body; }

  TemporaryFolder folder_;
  std::unique_ptr<ViewServer> server_;
  std::thread thread_;
  std::unique_ptr<httplib::Client> client_;
};

TEST_F(Server, ServesPageSceneAndFramesOfBothRuns) {
  EXPECT_EQ(body_of("/"), "<p>page");
  EXPECT_EQ(body_of("/scene.js"), "first");
  EXPECT_EQ(body_of("/with/scene.js"), "second");
  EXPECT_EQ(body_of("/frame_00012.js"), "twelve");
  EXPECT_THAT(server_->address(), HasSubstr("/?with=with/"));
}

TEST_F(Server, NothingElseIsServed) {
  for (const char* path :
       {"/note.txt", "/index.html", "/../scene.js", "/%2e%2e/scene.js", "/..%2fscene.js",
        "/with/../../run/scene.js", "/with/%2e%2e/%2e%2e/run/scene.js", "/.//scene.js",
        "//scene.js", "/frame_00001.js", "/frame_1.js", "/frame_00012.js%00.txt", "/scene.js/",
        "/SCENE.JS", "/frame_00012.js/../../scene.js", "/etc/passwd", "/with/"})
    EXPECT_EQ(status_of(path), 404) << path;
}

TEST_F(Server, LinksAreNotFollowed) { EXPECT_EQ(status_of("/frame_00099.js"), 404); }

TEST_F(Server, HeadersKeepThePageToItself) {
  const auto answer = client_->Get("/scene.js");
  EXPECT_EQ(answer->get_header_value("Content-Security-Policy"), "default-src 'none'");
  EXPECT_EQ(answer->get_header_value("X-Content-Type-Options"), "nosniff");
  EXPECT_EQ(answer->get_header_value("Referrer-Policy"), "no-referrer");
  EXPECT_EQ(answer->get_header_value("Cross-Origin-Resource-Policy"), "same-origin");
  EXPECT_EQ(answer->get_header_value("Cache-Control"), "no-store");
  EXPECT_EQ(answer->get_header_value("Content-Type"), "text/javascript; charset=utf-8");
}

TEST_F(Server, OnlyReads) {
  EXPECT_EQ(client_->Head("/scene.js")->status, 200);
  EXPECT_EQ(client_->Head("/scene.js")->body, "");
  EXPECT_EQ(client_->Post("/scene.js", "x", "text/plain")->status, 405);
  EXPECT_EQ(client_->Put("/scene.js", "x", "text/plain")->status, 405);
  EXPECT_EQ(client_->Delete("/scene.js")->status, 405);
  EXPECT_EQ(client_->Options("/scene.js")->status, 405);
  EXPECT_EQ(folder_.read("run/view/scene.js"), "first");
}

TEST_F(Server, OtherNamesOfThisHostAreRefused) {
  const std::string port = std::to_string(port_of(*server_));
  EXPECT_EQ(status_of("/scene.js", {{"Host", "localhost:" + port}}), 200);
  for (const std::string& host :
       {"evil.example:" + port, std::string("127.0.0.1"), std::string("localhost"),
        "127.0.0.1.evil.example:" + port, std::string("")})
    EXPECT_EQ(status_of("/scene.js", {{"Host", host}}), 403) << host;
}

TEST_F(Server, PagesOfOtherSitesAreRefused) {
  EXPECT_EQ(status_of("/scene.js", {{"Sec-Fetch-Site", "same-origin"}}), 200);
  EXPECT_EQ(status_of("/", {{"Sec-Fetch-Site", "none"}}), 200);
  EXPECT_EQ(status_of("/scene.js", {{"Sec-Fetch-Site", "cross-site"}}), 403);
  EXPECT_EQ(status_of("/scene.js", {{"Sec-Fetch-Site", "same-site"}}), 403);
}

TEST_F(Server, APortThatIsTakenIsAFaultOnlyWhenItWasAskedFor) {
  const ServedView view{folder_ / "run/view", std::nullopt, "", ""};
  const int taken = port_of(*server_);
  const Fault fault = fault_of([&] { const ViewServer second(view, taken); });
  EXPECT_EQ(fault.place, "--port");
  EXPECT_THAT(fault.problem, HasSubstr(std::to_string(taken)));
  const ViewServer third(view, std::nullopt);
  EXPECT_NE(port_of(third), taken);
}

TEST(ViewServer, AFolderThatIsALinkIsRefused) {
  const TemporaryFolder folder;
  fs::create_directories(folder / "elsewhere");
  fs::create_symlink(folder / "elsewhere", folder / "view");
  const Fault fault = fault_of([&] {
    const ViewServer server({folder / "view", std::nullopt, "", ""}, std::nullopt);
  });
  EXPECT_THAT(fault.problem, HasSubstr("link"));
}

}  // namespace
}  // namespace sabo
