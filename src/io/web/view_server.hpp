#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace sabo {

/// What is served.
struct ServedView {
  std::filesystem::path folder;                ///< view/ of a run
  std::optional<std::filesystem::path> other;  ///< view/ of a second run, to compare with
  std::string_view page;                       ///< HTML of "/"
  std::string_view policy;                     ///< Content-Security-Policy of the page
};

/// Serves the 3D view on 127.0.0.1 and nowhere else. It answers GET and HEAD for "/", "/scene.js"
/// and "/frame_*.js", those of the second run below "/with/", and nothing else: names come from a
/// fixed pattern, and a symbolic link is not followed. Requests that name another host (DNS
/// rebinding) or that a page of another site sends are refused.
class ViewServer {
 public:
  /// Takes the port, or if it is not given 8642 or any that is free. Throws CaseError when the port
  /// is taken and when a folder is a symbolic link.
  ViewServer(ServedView view, std::optional<int> port);
  ~ViewServer();
  ViewServer(const ViewServer&) = delete;
  ViewServer& operator=(const ViewServer&) = delete;

  /// "http://127.0.0.1:8642/"; the page shows both runs if there are two.
  std::string address() const;

  /// Answers until stop() is called. Throws RunError when it ends by itself.
  void serve();
  void stop();

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace sabo
