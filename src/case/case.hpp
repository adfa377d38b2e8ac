#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "base/describe.hpp"
#include "case/body_case.hpp"
#include "case/inflow_case.hpp"
#include "case/load_case.hpp"
#include "case/material_case.hpp"
#include "case/measure_case.hpp"
#include "case/numerics_case.hpp"
#include "case/observed_case.hpp"
#include "case/release_case.hpp"
#include "case/run_case.hpp"
#include "case/structure_case.hpp"
#include "case/terrain_case.hpp"

namespace sabo {

/// The case as plain structs, one a table. Each member is described once, where it is declared; see
/// base/describe.hpp. A line is given by a vector file (`line = "dam.gpkg"`) or by coordinates
/// (`line = [[x, y], ...]`, a third number is z); both are in the coordinates of the DEM, files in
/// another CRS are reprojected.
struct Case {
  std::string title;
  std::string note;  ///< shown wherever the results are shown, e.g. "generated terrain"
  TerrainCase terrain;
  ReleaseCase release;
  std::vector<InflowCase> inflows;
  MaterialCase material;
  std::vector<StructureCase> structures;
  std::vector<BodyCase> bodies;
  std::vector<SectionCase> sections;
  std::vector<GaugeCase> gauges;
  std::vector<ZoneCase> zones;
  LoadCase loads;
  PathCase path;
  std::vector<ReferenceCase> references;
  ObservedCase observed;
  NumericsCase numerics;
  RunCase run;
  std::filesystem::path folder;  ///< of the case file, absolute; relative paths start here

  /// Calls v.table(name, help, struct) and v.tables(name, help, vector of structs).
  template <class V>
  void describe(V&& v) {
    v(Key{"title", "", "one line, shown in the outputs"}, title);
    v(Key{"note", "", "shown wherever the results are shown, e.g. where the terrain comes from"},
      note);
    v.table("terrain", "the ground", terrain);
    v.table("release", "the mass that starts to move", release);
    v.tables("inflow", "discharges that come in through lines", inflows);
    v.table("material", "its density and law of flow", material);
    v.tables("structure", "works in the way", structures);
    v.tables("body", "solids that stand in the flow or hold it: boxes, tanks, meshes", bodies);
    v.tables("section", "lines that measure discharge", sections);
    v.tables("gauge", "points whose depth, speed and pressure are measured", gauges);
    v.tables("zone", "areas whose depth is measured", zones);
    v.table("loads", "how forces on structures and bodies are read", loads);
    v.table("path", "the line along which the front is measured", path);
    v.tables("reference", "volumes known from elsewhere, printed beside the run's", references);
    v.table("observed", "what a survey found, for sabo compare", observed);
    v.table("numerics", "the method", numerics);
    v.table("run", "how long, and what is written", run);
  }
};

}  // namespace sabo
