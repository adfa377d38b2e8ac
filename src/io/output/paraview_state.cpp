#include "io/output/paraview_state.hpp"

#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "base/colour.hpp"
#include "io/output/colour_scale.hpp"
#include "io/output/markup.hpp"

namespace sabo {
namespace {

// Where ParaView keeps an object: at the data, with the client, where pictures are made, at both.
enum class Server { data = 1, client = 16, layout = 20, rendering = 21 };

constexpr Colour ground_paint{217, 212, 204}, body_paint{190, 24, 39};

// Numbers of the objects within the file; none of them may occur twice.
enum Id {
  flow = 11,
  surface,
  ground,
  bodies,
  depth_colours = 21,
  flow_shape = 31,
  surface_shape,
  ground_shape,
  bodies_shape,
  depth_bar,
  view = 41,
  time_keeper = 51,
  animation,
  animated_time,
  layout
};

/// The objects of a state, one after the other, and the names under which they are filed.
class StateText {
 public:
  /// Begins an object; its properties follow.
  void begin(const char* group, const char* type, int id, Server server) {
    id_ = id;
    text_ += fmt::format("<Proxy group=\"{}\" type=\"{}\" id=\"{}\" servers=\"{}\">\n", group, type,
                         id, static_cast<int>(server));
  }
  void end() { text_ += "</Proxy>\n"; }

  void set(const char* name, const std::vector<std::string>& values) {
    open(name, values.size());
    for (std::size_t k = 0; k < values.size(); ++k)
      text_ += fmt::format("<Element index=\"{}\" value=\"{}\"/>", k, escaped(values[k]));
    text_ += "</Property>\n";
  }
  void set(const char* name, const std::vector<double>& values) {
    std::vector<std::string> texts;
    for (const double value : values) texts.push_back(fmt::format("{:.9g}", value));
    set(name, texts);
  }
  void refer(const char* name, const std::vector<int>& ids) {
    open(name, ids.size());
    for (const int id : ids) text_ += fmt::format("<Proxy value=\"{}\" output_port=\"0\"/>", id);
    text_ += "</Property>\n";
  }
  void raw(const std::string& xml) { text_ += xml; }

  void file_under(const char* collection, int id, const std::string& name) {
    text_ += fmt::format(
        "<ProxyCollection name=\"{}\"><Item id=\"{}\" name=\"{}\"/></ProxyCollection>\n",
        collection, id, escaped(name));
  }
  std::string take() { return std::move(text_); }

 private:
  void open(const char* name, std::size_t count) {
    text_ += fmt::format("<Property name=\"{0}\" id=\"{1}.{0}\" number_of_elements=\"{2}\">", name,
                         id_, count);
  }

  std::string text_;
  int id_ = 0;
};

std::vector<double> rgb(const Colour& colour) {
  return {colour[0] / 255.0, colour[1] / 255.0, colour[2] / 255.0};
}

void add_reader(StateText& text, const char* type, int id, const std::filesystem::path& file) {
  text.begin("sources", type, id, Server::data);
  text.set("FileName", {file.string()});
  text.end();
  text.file_under("sources", id, file.filename().string());
}

/// How a source is shown: by an array of its points, or in one colour.
void begin_shape(StateText& text, int id, int source, bool is_shown, const char* array) {
  text.begin("representations", "GeometryRepresentation", id, Server::rendering);
  text.refer("Input", {source});
  text.set("Visibility", std::vector<double>{is_shown ? 1.0 : 0.0});
  // The fourth entry says whose array it is: 0, of the points.
  text.set("ColorArrayName", {"", "", "", *array ? "0" : "", array});
}

void end_shape(StateText& text, int id) {
  text.end();
  text.file_under("representations", id, fmt::format("GeometryRepresentation{}", id));
}

void add_painted(StateText& text, int id, int source, const Colour& paint) {
  begin_shape(text, id, source, true, "");
  text.set("DiffuseColor", rgb(paint));
  text.set("AmbientColor", rgb(paint));
  end_shape(text, id);
}

void add_colours(StateText& text, double deepest) {
  constexpr int pieces = 8;
  std::vector<double> points;
  for (int k = 0; k <= pieces; ++k) {
    const double share = static_cast<double>(k) / pieces;
    points.push_back(share * deepest);
    for (const double part : rgb(flow_colour(share))) points.push_back(part);
  }
  text.begin("lookup_tables", "PVLookupTable", depth_colours, Server::rendering);
  text.set("RGBPoints", points);
  text.set("ColorSpace", std::vector<double>{0});  // between the points in RGB
  text.set("ScalarRangeInitialized", std::vector<double>{1});
  text.set("AutomaticRescaleRangeMode", std::vector<double>{-1});  // never
  text.end();
  text.file_under("lookup_tables", depth_colours, "depth [m].PVLookupTable");

  text.begin("representations", "ScalarBarWidgetRepresentation", depth_bar, Server::rendering);
  text.refer("LookupTable", {depth_colours});
  text.set("Title", {"depth [m]"});
  text.set("ComponentTitle", {""});
  text.set("Visibility", std::vector<double>{1});
  text.set("Enabled", std::vector<double>{1});
  for (const char* part : {"TitleColor", "LabelColor"}) text.set(part, rgb({}));
  text.end();
  text.file_under("scalar_bars", depth_bar, "ScalarBarWidgetRepresentation1");
}

void add_view(StateText& text, const ParaviewState& state, const std::vector<int>& shapes) {
  const Vec3d middle = 0.5 * (state.flow.low + state.flow.high);
  const Vec3d size = state.flow.size();
  const double distance = 1.2 * std::max({size.x, size.y, size.z, 1.0});
  // From beside the longer side of the flow.
  const Vec3d from =
      size.x >= size.y ? Vec3d{0, -distance, distance} : Vec3d{distance, 0, distance};
  const Vec3d eye = middle + from;
  text.begin("views", "RenderView", view, Server::rendering);
  text.refer("Representations", shapes);
  text.set("UseColorPaletteForBackground", std::vector<double>{0});
  text.set("Background", std::vector<double>{1, 1, 1});
  text.set("CameraPosition", std::vector<double>{eye.x, eye.y, eye.z});
  text.set("CameraFocalPoint", std::vector<double>{middle.x, middle.y, middle.z});
  text.set("CenterOfRotation", std::vector<double>{middle.x, middle.y, middle.z});
  text.set("CameraViewUp", std::vector<double>{0, 0, 1});
  text.end();
  text.file_under("views", view, "RenderView1");
  text.begin("misc", "ViewLayout", layout, Server::layout);
  text.raw(
      fmt::format("<Layout number_of_elements=\"1\"><Item direction=\"0\" fraction=\"0.5\" "
                  "view=\"{}\"/></Layout>\n",
                  static_cast<int>(view)));
  text.end();
  text.file_under("layouts", layout, "Layout #1");
}

/// Time goes from frame to frame.
void add_time(StateText& text, double end, const std::vector<int>& sources) {
  text.begin("misc", "TimeKeeper", time_keeper, Server::client);
  text.refer("TimeSources", sources);
  text.refer("Views", {view});
  text.end();
  text.file_under("timekeeper", time_keeper, "TimeKeeper1");
  text.begin("animation", "AnimationScene", animation, Server::client);
  text.set("PlayMode", std::vector<double>{2});
  text.set("StartTime", std::vector<double>{0});
  text.set("EndTime", std::vector<double>{end});
  text.refer("TimeKeeper", {time_keeper});
  text.refer("ViewModules", {view});
  text.refer("Cues", {animated_time});
  text.end();
  text.file_under("animation", animation, "AnimationScene1");
  text.begin("animation", "TimeAnimationCue", animated_time, Server::client);
  text.refer("AnimatedProxy", {time_keeper});
  text.set("AnimatedPropertyName", {"Time"});
  text.end();
  text.file_under("animation", animated_time, "TimeAnimationCue1");
}

}  // namespace

std::string paraview_state(const ParaviewState& state) {
  StateText text;
  std::vector<int> sources{flow, surface, ground};
  std::vector<int> shapes{flow_shape, surface_shape, ground_shape, depth_bar};
  add_reader(text, "PVDReader", flow, state.folder / "flow.pvd");
  add_reader(text, "PVDReader", surface, state.folder / "surface.pvd");
  add_reader(text, "XMLPolyDataReader", ground, state.folder / "ground.vtp");
  if (state.has_bodies) {
    add_reader(text, "XMLPolyDataReader", bodies, state.folder / "bodies.vtp");
    sources.push_back(bodies);
    shapes.push_back(bodies_shape);
  }
  add_colours(text, state.deepest > 0 ? state.deepest : 1);
  begin_shape(text, flow_shape, flow, false, "velocity [m/s]");
  text.set("Representation", {"Points"});
  text.set("PointSize", std::vector<double>{4});
  end_shape(text, flow_shape);
  begin_shape(text, surface_shape, surface, true, "depth [m]");
  text.refer("LookupTable", {depth_colours});
  end_shape(text, surface_shape);
  add_painted(text, ground_shape, ground, ground_paint);
  if (state.has_bodies) add_painted(text, bodies_shape, bodies, body_paint);
  add_view(text, state, shapes);
  add_time(text, state.end, sources);
  return "<ParaView>\n<ServerManagerState version=\"5.11.0\">\n" + text.take() +
         "</ServerManagerState>\n</ParaView>\n";
}

}  // namespace sabo
