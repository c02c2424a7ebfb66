// SPDX-License-Identifier: Apache-2.0
// blysk render: its files, its report, and what it says of bad use and bad scenes.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "tb/catch_text.h"
#include "tb/cli/test/program.h"

namespace {

using json = nlohmann::json;

constexpr const char* kSmall = " --size 48x48 --density 12 ";

std::string in(const scratch& folder, const std::string& name) {
  return quoted(folder.path(name));
}

/// The report of a rendering that has to succeed.
json rendered(const scratch& folder, const std::string& arguments, const std::string& picture = "p.png") {
  const outcome run = run_blysk(folder, fmt::format("render {} --output {} --report {}", arguments,
                                                    in(folder, picture), in(folder, "r.json")));
  CAPTURE(arguments, run.err);
  REQUIRE(run.status == 0);
  CHECK(slurp(folder.path(picture)).starts_with("\x89PNG"));
  return json::parse(slurp(folder.path("r.json")));
}

/// Ends with status 2 and one line that has the part, and leaves no file behind.
void refuses(const scratch& folder, const std::string& arguments, const std::string& part) {
  const std::vector<std::string> before = folder.names();
  const outcome run = run_blysk(folder, fmt::format("render {} --output {} --report {}", arguments,
                                                    in(folder, "x.png"), in(folder, "x.json")));
  CAPTURE(arguments, run.err, part);
  CHECK(run.status == 2);
  CHECK(run.out.empty());
  CHECK(run.err.starts_with("blysk: "));
  CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
  CHECK(run.err.find(part) != std::string::npos);
  CHECK(folder.names().size() == before.size());
}

const std::string kTriangle = "v -1 -1 0\nv 1 -1 0\nv 0 1 0\n";

}  // namespace

TEST_CASE("the report has what was computed and what it cost", "[cli][render]") {
  const scratch folder;
  const json report =
      rendered(folder, std::string("sphere --engine systemc") + kSmall + "--watch highlight --vcd " +
                           in(folder, "w.vcd") + " --compare " + in(folder, "c.png"));
  for (const char* key : {"pixels", "pixels_in_highlight", "device_writes", "triangles",
                          "triangles_in_highlight", "units", "simulated_ns", "nmse", "messages"}) {
    CAPTURE(key);
    CHECK(report.contains(key));
  }
  CHECK(report["triangles"] == 12 * 24 * 2 - 2 * 24);
  // The sphere fills nine tenths of the side.
  CHECK(report["pixels"].get<double>() == Approx(3.14159 / 4 * 0.81 * 48 * 48).epsilon(0.03));
  CHECK(report["pixels_in_highlight"] > 20);
  CHECK(report["device_writes"] == report["pixels_in_highlight"]);
  CHECK(report["watched_writes"] > 5);
  CHECK(report["watched_writes"] < report["device_writes"]);
  CHECK(report["blocks"].size() > 10);
  CHECK(report["cycles"] >= 2 * report["device_writes"].get<int>());
  CHECK(report["simulated_ns"] == 10 * report["cycles"].get<int>());
  CHECK(report["nmse"] > 0);
  CHECK(report["units"] == json{"ambient", "diffuse", "specular", top_of("q16"), "saturation"});
  CHECK(report["messages"].empty());
  double frame_s = 0;
  std::vector<std::string> phases;
  for (const auto& [phase, seconds] : report["host_s"].items()) {
    phases.push_back(phase);
    if (phase != "reading" && phase != "reference" && phase != "picture") frame_s += seconds.get<double>();
  }
  CHECK(phases == std::vector<std::string>{"device", "picture", "plan", "reading", "reference", "shading",
                                           "visibility"});
  CHECK(report["frames_per_second"].get<double>() == Approx(1 / frame_s));
  CHECK(slurp(folder.path("c.png")).starts_with("\x89PNG"));
  const std::string waves = slurp(folder.path("w.vcd"));
  CHECK(waves.find("$enddefinitions") != std::string::npos);
  CHECK(waves.find("cos18") != std::string::npos);
}

TEST_CASE("engines, threads, watched pixels and left out effects change no bit of the picture",
          "[cli][render]") {
  const scratch folder;
  for (const char* shading : {"phong", "gouraud", "flat", "polynomial"}) {
    const std::string scene = fmt::format("spheres {} --shading {} ", kSmall, shading);
    const json report = rendered(folder, scene + "--threads 1", "first.png");
    const std::string first = slurp(folder.path("first.png"));
    for (const char* options :
         {"--threads 3", "--effects all --threads 2", "--engine systemc", "--engine systemc --effects all",
          "--engine verilator", "--engine verilator --effects all", "--watch 20,18,12,4",
          "--watch highlight --effects all"}) {
      CAPTURE(shading, options);
      const json other = rendered(folder, scene + options);
      CHECK(slurp(folder.path("p.png")) == first);
      const bool all = std::string(options).find("all") != std::string::npos;
      CHECK(other["pixels_in_highlight"] == report["pixels_in_highlight"]);
      CHECK(other["device_writes"] == (all ? report["points"] : report["device_writes"]));
    }
    rendered(folder, scene + "--engine golden", "golden.png");
    rendered(folder, scene + "--engine golden --effects all");
    CHECK(slurp(folder.path("p.png")) == slurp(folder.path("golden.png")));
  }
}

TEST_CASE("test models of assimp look the same with all effects under every engine", "[cli][render]") {
  const scratch folder;
  std::size_t lit = 0;
  for (const char* name : {"3DS/test1.3ds", "3DS/cube_with_diffuse_texture.3DS", "OBJ/regr01.obj",
                           "OBJ/box.obj", "OBJ/WusonOBJ.obj"}) {
    const std::string model = quoted(std::string("/usr/share/assimp/models/") + name) + " --size 40x40 ";
    for (const char* engine : {"bit", "systemc", "verilator", "golden"}) {
      CAPTURE(name, engine);
      const json few = rendered(folder, model + "--engine " + engine, "few.png");
      rendered(folder, model + "--effects all --engine " + engine, "all.png");
      CHECK(slurp(folder.path("few.png")) == slurp(folder.path("all.png")));
      lit += few["pixels_in_highlight"] > 0 ? 1U : 0U;
    }
  }
  CHECK(lit == 2 * 4);  // those of OBJ: the models of 3DS are matte
}

constexpr const char* kTriangleInGltf =
    R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0]}],
  "nodes": [{"mesh": 0}], "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
  "buffers": [{"uri": "t.bin", "byteLength": 36}], "bufferViews": [{"buffer": 0, "byteLength": 36}],
  "accessors": [{"bufferView": 0, "componentType": 5126, "count": 3, "type": "VEC3", "min": [0, 0, 0],
                 "max": [1, 1, 0]}]})";

/// The buffer: the corners (0, 0, 0), (1, 0, 0) and (0, 1, 0).
std::string triangle_of_gltf() {
  const std::array<float, 9> corners{0, 0, 0, 1, 0, 0, 0, 1, 0};
  return {reinterpret_cast<const char*>(corners.data()), sizeof corners};
}

TEST_CASE("no result replaces a file that was read, nor a frame another result", "[cli][render]") {
  const scratch folder;
  const std::vector<std::pair<std::string, std::string>> files{
      {"t.obj", "mtllib t.mtl\n" + kTriangle + "usemtl a\nf 1 2 3\n"},
      {"t.mtl", "newmtl a\nKd 1 0 0\n"},
      {"t.json", "{\"mesh\": \"t.obj\"}"},
      {"t.gltf", kTriangleInGltf},
      {"t.bin", triangle_of_gltf()}};
  for (const auto& [name, text] : files) folder.write(name, text);
  const std::map<std::string, std::set<std::string>> read_by{{"t.obj", {"t.obj", "t.mtl"}},
                                                             {"t.json", {"t.json", "t.obj", "t.mtl"}},
                                                             {"t.gltf", {"t.gltf", "t.bin"}}};
  for (const auto& [scene, names] : read_by) {
    for (const auto& [name, text] : files) {
      if (!names.contains(name)) continue;
      for (const char* option : {"--report", "--compare", "--engine systemc --vcd"}) {
        CAPTURE(scene, name, option);
        const outcome run =
            run_blysk(folder, fmt::format("render {} --size 8x8 --output {} {} {}", in(folder, scene),
                                          in(folder, "x.png"), option, in(folder, name)));
        CHECK(run.status == 2);
        CHECK(run.err.find("is given by SCENE and --") != std::string::npos);
        CHECK(slurp(folder.path(name)) == text);
      }
    }
  }
  const outcome run =
      run_blysk(folder, fmt::format("render sphere --size 8x8 --animate 2 --output {} --report {}",
                                    in(folder, "a.png"), in(folder, "a-0002.png")));
  CHECK(run.status == 2);
  CHECK(run.err.find("a-0002.png: is given by --report and --output") != std::string::npos);
}

namespace {

std::string lights_of(int count) {
  std::string text;
  for (int i = 0; i < count; ++i) text += std::string(i == 0 ? "" : ", ") + "{\"direction\": [0, 0, 1]}";
  return text;
}

/// A device that a scene cannot have.
std::string device_without_points(const scratch& folder) {
  const json listed = json::parse(run_blysk(folder, "list --json").out);
  for (const json& each : listed["devices"]) {
    if (each["stimulus"] != json{"n", "cos", "r", "g", "b"}) return each["name"];
  }
  return "";
}

}  // namespace

TEST_CASE("what a scene file has wrong is said with file and line", "[cli][render]") {
  const scratch folder;
  for (const auto& [member, words] : std::vector<std::pair<std::string, std::string>>{
           {"\"shading\": \"Phong\"", "s.JSON:2: shading: shading Phong does not exist"},
           {"\"engine\": \"x\"", "s.JSON:2: engine: "},
           {"\"device\": \"x\"", "s.JSON:2: device: "},
           {"\"lights\": [" + lights_of(65) + "]", "s.JSON:2: lights: has 65 lights, expected at most 64"},
           {"\"device\": \"" + device_without_points(folder) + "\"", "s.JSON:2: device: "},
           {"\"format\": \"q9\"", "s.JSON:2: format: "},
           {"\"normalisation\": \"x\"", "s.JSON:2: normalisation: "},
           {"\"perspective\": \"x\"", "s.JSON:2: perspective: "}}) {
    folder.write("s.JSON", "{\"mesh\": \"sphere\",\n" + member + "}");
    refuses(folder, in(folder, "s.JSON"), words);
  }
  // What the command line says comes first, and hides no fault of the file.
  for (const auto& [member, option] :
       std::vector<std::pair<std::string, std::string>>{{"\"shading\": \"Phong\"", " --shading flat"},
                                                        {"\"size\": [0, 4]", " --size 8x8"},
                                                        {"\"device\": \"x\"", " --device " + kDevice},
                                                        {"\"format\": \"q9\"", " --format q8"},
                                                        {"\"density\": 1", " --density 8"}}) {
    folder.write("s.JSON", "{\"mesh\": \"sphere\",\n" + member + "}");
    refuses(folder, in(folder, "s.JSON") + option, "s.JSON:2: ");
  }
  for (const char* whole : {"[]", "3", "\"sphere\"", "{}", "{\"density\": 3}"}) {
    folder.write("s.JSON", std::string("\n") + whole + "\n");
    refuses(folder, in(folder, "s.JSON"), "s.JSON:2: the file: ");
  }
  folder.write("s.JSON", "{\"mesh\": \"s.JSON\"}");
  refuses(folder, in(folder, "s.JSON"), "s.JSON:1: mesh: is a scene, expected a mesh");
  for (const char* none : {"nosuch.obj", "."}) {
    folder.write("s.JSON", fmt::format("{{\"mesh\":\n\"{}\"}}", none));
    refuses(folder, in(folder, "s.JSON"),
            "mesh: is no file, expected one beside the scene or a built-in shape");
  }
  folder.write("s.JSON", "{\"mesh\": \"\"}");
  refuses(folder, in(folder, "s.JSON"), "s.JSON:1: mesh: is empty");
  // A name before * in the alphabet keeps what is said of it.
  folder.write("m.mtl", "newmtl #a\nKd 1 0 0\nKs 1 1 1\n");
  folder.write("m.obj", "mtllib m.mtl\n" + kTriangle + "usemtl #a\nf 1 2 3\n");
  folder.write(
      "s.JSON",
      "{\"mesh\": \"m.obj\", \"materials\": {\"#a\": {\"ks\": [0, 0, 0]}, \"*\": {\"ks\": [1, 1, 1]}}}");
  CHECK(rendered(folder, in(folder, "s.JSON") + " --size 8x8")["units"] == json{"diffuse", "saturation"});
}

TEST_CASE("long words of a file make no long message, and no message needs standard error", "[cli][render]") {
  const scratch folder;
  folder.write("l.obj", "v " + std::string(1'000'000, '9') + "x 0 0\n");
  const outcome run = run_blysk(folder, "render " + in(folder, "l.obj") + " --explain");
  CHECK(run.status == 2);
  CHECK(run.err.size() < 3000);
  folder.write("t.obj", kTriangle + "f 1 2 3\n");
  CHECK(std::system(fmt::format("{} render {} --size 8x8 --output {} >/dev/null 2>&-", quoted(BLYSK_PROGRAM),
                                in(folder, "t.obj"), in(folder, "t.png"))
                        .c_str()) == 0);
  CHECK(slurp(folder.path("t.png")).starts_with("\x89PNG"));
}

TEST_CASE("a PLY file that ends early is refused, and one without a material is plain", "[cli][render]") {
  const scratch folder;
  const std::string head =
      "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\n"
      "property list uchar int vertex_indices\nend_header\n";
  const std::string rows = "-1 -1 0\n1 -1 0\n0 1 0\n3 0 1 2\n";
  folder.write("whole.ply", "ply\nformat ascii 1.0\n" + head + rows);
  const json report = rendered(folder, in(folder, "whole.ply") + " --size 8x8");
  CHECK(report["triangles"] == 1);
  CHECK(report["messages"][0] == "a mesh has no material, a plain one taken");
  // Cut at the end of each number but the last one.
  for (std::size_t end = rows.size() - 3; end > 0; --end) {
    if (rows[end] != ' ' && rows[end] != '\n') continue;
    folder.write("cut.ply", "ply\nformat ascii 1.0\n" + head + rows.substr(0, end) + "\n");
    refuses(folder, in(folder, "cut.ply"), "cut.ply:");
  }
  const std::string binary(
      "\0\0\x80\xBF\0\0\x80\xBF\0\0\0\0\0\0\x80\x3F\0\0\x80\xBF\0\0\0\0\0\0\0\0\0\0\x80\x3F\0\0\0\0"
      "\x03\0\0\0\0\x01\0\0\0\x02\0\0\0",
      49);
  folder.write("b.ply", "ply\nformat binary_little_endian 1.0\n" + head + binary);
  CHECK(rendered(folder, in(folder, "b.ply") + " --size 8x8")["triangles"] == 1);
  folder.write("b.ply", "ply\nformat binary_little_endian 1.0\n" + head + binary.substr(0, 48));
  refuses(folder, in(folder, "b.ply"), "b.ply: has 0 of 1 elements 'face', expected all of them");
}

TEST_CASE("a file of the library without a material is plain, and what it does not use is not spoken of",
          "[cli][render]") {
  const scratch folder;
  folder.write("t.off", "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n");
  const auto gltf = [&](const std::string& name, const std::string& materials, const std::string& of_mesh) {
    const std::string points(
        "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA");
    folder.write(name,
                 R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)" +
                     materials + R"("meshes":[{"primitives":[{"attributes":{"POSITION":0})" + of_mesh +
                     R"(}]}],"buffers":[{"byteLength":36,"uri":")" + points +
                     R"("}],"bufferViews":[{"buffer":0,"byteLength":36}],"accessors":[{"bufferView":0,)" +
                     R"("componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,1,0]}]})");
    return rendered(folder, in(folder, name) + " --size 8x8")["messages"].dump();
  };
  const std::string plain = "a mesh has no material, a plain one taken";
  CHECK_THAT(rendered(folder, in(folder, "t.off") + " --size 8x8")["messages"].dump(),
             ContainsSubstring(plain));
  folder.write(
      "m.ply",
      "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nelement material 1\n"
      "property uchar diffuse_red\nproperty uchar diffuse_green\nproperty uchar diffuse_blue\n"
      "property uchar specular_red\nproperty uchar specular_green\nproperty uchar specular_blue\n"
      "end_header\n-1 -1 0\n1 -1 0\n0 1 0\n3 0 1 2\n200 0 0 200 0 0\n");
  CHECK_THAT(rendered(folder, in(folder, "m.ply") + " --size 8x8")["messages"].dump(),
             !ContainsSubstring(plain));
  folder.write("t.raw", "mesh\n0 0 0 1 0 0 0 1 0\n");
  folder.write("t.x",
               "xof 0303txt 0032\nMesh m {\n3;\n0.0;0.0;0.0;,\n1.0;0.0;0.0;,\n0.0;1.0;0.0;;\n1;\n"
               "3;0,1,2;;\n}\n");
  const auto ac = [](const char* material) {
    return std::string("AC3Db\n") + material +
           "OBJECT world\nkids 1\nOBJECT poly\nnumvert 3\n0 0 0\n1 0 0\n0 1 0\nnumsurf 1\nSURF 0x20\n"
           "mat 0\nrefs 3\n0 0 0\n1 0 0\n2 0 0\nkids 0\n";
  };
  folder.write("t.ac", ac(""));
  for (const char* name : {"t.raw", "t.x", "t.ac"}) {
    CAPTURE(name);
    CHECK_THAT(rendered(folder, in(folder, name) + " --size 8x8")["messages"].dump(),
               ContainsSubstring(plain));
  }
  folder.write("t.ac", ac("MATERIAL \"\" rgb 0.6 0.6 0.6  amb 0.2 0.2 0.2  emis 0 0 0  "
                          "spec 0.5 0.5 0.5  shi 10  trans 0\n"));
  CHECK_THAT(rendered(folder, in(folder, "t.ac") + " --size 8x8")["messages"].dump(),
             !ContainsSubstring(plain));
  CHECK_THAT(gltf("none.gltf", "", ""), ContainsSubstring(plain));
  const std::string one =
      R"("materials":[{"name":"x","pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1]}}],)";
  CHECK_THAT(gltf("one.gltf", one, R"(,"material":0)"), ContainsSubstring("material 'x'") &&
                                                            !ContainsSubstring("material ''") &&
                                                            !ContainsSubstring("plain"));
  CHECK_THAT(gltf("unused.gltf", one, ""), !ContainsSubstring("'x'") && ContainsSubstring(plain));
}

TEST_CASE("waves of pixels without a write are said to be empty", "[cli][render]") {
  const scratch folder;
  const auto said = [&](const std::string& arguments) {
    const outcome run = run_blysk(folder, "render sphere --size 32x32 --output " + in(folder, "p.png") +
                                              " --vcd " + in(folder, "w.vcd") + " " + arguments);
    CAPTURE(run.err);
    CHECK(run.status == 0);
    return run.err.find("--watch: no watched pixel is in a highlight") != std::string::npos;
  };
  CHECK(said("--watch 0,0"));
  CHECK(said("--watch highlight --light 0,0,-1"));
  CHECK(!said("--watch highlight"));
  const outcome dark =
      run_blysk(folder, "render sphere --size 32x32 --engine systemc --light 0,0,-1 --output " +
                            in(folder, "p.png") + " --vcd " + in(folder, "w.vcd"));
  CHECK(dark.status == 0);
  CHECK_THAT(dark.err, ContainsSubstring("--vcd: no pixel is in a highlight, so the device has no write"));
  const outcome away =
      run_blysk(folder, "render sphere --eye 0,0,4 --target 0,0,8 --size 8x8 --units systemc --units-vcd " +
                            in(folder, "u.vcd") + " --output " + in(folder, "p.png"));
  CAPTURE(away.err);
  CHECK(away.status == 0);
  CHECK_THAT(away.err, ContainsSubstring("--units-vcd: no pixel sees the mesh, so the units have no row"));
}

TEST_CASE("a plane that reaches behind the eye fills its half of the picture", "[cli][render]") {
  const scratch folder;
  folder.write("am.mtl", "newmtl a\nillum 1\nKa 1 1 1\nKd 1 1 1\n");
  for (const double size : {1e1, 1e6, 1e7, 1e8, 1e12}) {
    CAPTURE(size);
    folder.write("g.obj",
                 fmt::format("mtllib am.mtl\nv -{0} -1 -{0}\nv {0} -1 -{0}\nv {0} -1 {0}\nv -{0} -1 {0}\n"
                             "usemtl a\nf 1 2 3 4\n",
                             size));
    // The plane lies a unit below the eye: at its end, in so many pixels below the middle, it begins.
    for (const int fov : {30, 90}) {
      const double rows = 32 / std::tan(fov * M_PI / 360) / size;
      const std::string arguments = fmt::format(" --eye 0,0,0 --target 0,0,-1 --size 64x64 --fov {}", fov);
      for (const char* renderer : {"", " --renderer segments --segment 1"}) {
        const json report = rendered(folder, in(folder, "g.obj") + arguments + renderer);
        CHECK(report["pixels"] == 64 * (32 - std::lround(rows)));
      }
      // Where a corner has no place on the picture the colour is that of the surface: the ambient light at least.
      rendered(folder, in(folder, "g.obj") + arguments + " --perspective screen --shading polynomial");
      const std::string screen = slurp(folder.path("p.png"));
      rendered(folder, in(folder, "g.obj") + arguments + " --shading polynomial");
      CHECK(slurp(folder.path("p.png")) == screen);
    }
  }
}

TEST_CASE("what a scene file gives to a material keeps its exponent", "[cli][render]") {
  const scratch folder;
  folder.write("n.mtl", "newmtl a\nillum 1\nKd .2 .2 .2\nKs 1 1 1\nNs 200\n");
  folder.write("n.obj", "mtllib n.mtl\n" + kTriangle + "usemtl a\nf 1 2 3\n");
  folder.write("n.json", R"({"mesh": "n.obj", "materials": {"*": {"ks": [1, 1, 1]}}})");
  const json report = rendered(folder, in(folder, "n.json") + " --size 8x8");
  CHECK_THAT(report["plan"].dump(), ContainsSubstring("specular on, n = 200"));
  CHECK(report["messages"][0].get<std::string>().starts_with("n.obj: "));
}

TEST_CASE("the watched row is that of the brightest highlight, not of the largest cosine", "[cli][render]") {
  const scratch folder;
  folder.write("w.mtl", "newmtl sharp\nKs 1\nNs 1000\nnewmtl wide\nKs 1\nNs 2\n");
  folder.write(
      "w.obj",
      "mtllib w.mtl\nv -1 0 0\nv 1 0 0\nv 1 1 0\nv -1 1 0\nv -1 -1 0\nv 1 -1 0\n"
      "vn 0.3 0 1\nvn 0.5 0 1\nusemtl sharp\nf 1//1 2//1 3//1 4//1\nusemtl wide\nf 5//2 6//2 2//2 1//2\n");
  const json report = rendered(folder, in(folder, "w.obj") +
                                           " --eye 0,0,5 --target 0,0,0 --light 0,0,1 --size 32x32 --watch "
                                           "highlight --vcd " +
                                           in(folder, "w.vcd"));
  CHECK(report["watched_writes"] > 5);
}

TEST_CASE("lobes are looked for where that can spare more than it takes", "[cli][render]") {
  const scratch folder;
  const json narrow = rendered(folder, "spheres --format q8 --size 32x32");
  CHECK_THAT(narrow["plan"].dump(), !ContainsSubstring("is not looked for"));
  CHECK(narrow["device_writes"] == narrow["pixels_in_highlight"]);
  const json wide = rendered(folder, "spheres --format q24 --size 32x32");
  const std::string picture = slurp(folder.path("p.png"));
  CHECK_THAT(wide["plan"].dump(), ContainsSubstring("where lobes begin is not looked for"));
  CHECK(wide["device_writes"] > wide["pixels_in_highlight"]);
  rendered(folder, "spheres --format q24 --size 32x32 --effects all");
  CHECK(slurp(folder.path("p.png")) == picture);
}

TEST_CASE("the sheet of a small picture has room for its titles", "[cli][render]") {
  const scratch folder;
  rendered(folder, "sphere --size 16x16 --compare " + in(folder, "c.png"));
  const std::string sheet = slurp(folder.path("c.png"));
  REQUIRE(sheet.size() > 24);
  const auto width = static_cast<unsigned char>(sheet[18]) * 256 + static_cast<unsigned char>(sheet[19]);
  CHECK(width > 3 * 150);
}

TEST_CASE("what the library passes over in silence is refused or said", "[cli][render]") {
  const scratch folder;
  const auto refuses_text = [&](const std::string& name, const std::string& text, const std::string& part) {
    folder.write(name, text);
    refuses(folder, in(folder, name), folder.path(name) + part);
  };
  const std::string square = "OFF\n4 2 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n";
  folder.write("whole.off", "# a comment\n" + square + "3 0 1 2\n3 0 2 3 # red\n");
  CHECK(rendered(folder, in(folder, "whole.off") + " --size 8x8")["triangles"] == 2);
  refuses_text("o.off", square + "3 0 1 2\n3 0 2 9\n", ":8: vertex 9 does not exist, expected less than 4");
  refuses_text("o.off", square + "3 0 1 2\n", ": has 1 of 2 faces, expected all of them");
  refuses_text("o.off", square + "3 0 1 2\n3 0 2\n", ":8: face has '', expected 3 indices");
  refuses_text("o.off", "OFF\n4 2 0\n-1 -1 0\n1 -1 x\n", ":4: vertex has 'x', expected three numbers");
  const std::string head =
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element face 1\nproperty list uchar int vertex_indices\nend_header\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n";
  refuses_text("p.ply", head + "3 1 2 x\n", ":14: has 'x', expected an integer");
  refuses_text("p.ply", head + "3 1 2 3.7\n", ":14: has '3.7', expected an integer");
  refuses_text("p.ply", head + "3 1 2 4\n", ":14: vertex 4 does not exist, expected less than 4");
  refuses_text("p.ply", head + "3 1 2 -1\n", ":14: vertex -1 does not exist, expected less than 4");
  refuses_text("p.ply", head + "3 1 2 3 3\n", ":14: has '3' behind element 'face', expected nothing");
  refuses_text("p.ply", head.substr(0, head.find("1 -1 0")) + "1 -1\n1 1 0\n-1 1 0\n3 1 2 3\n",
               ":10: ends within element 'vertex', expected more values");
  // What looks odd and is right.
  for (const auto& [name, text] : std::vector<std::pair<std::string, std::string>>{
           {"cr.off", "OFF\r4 2 0\r-1 -1 0\r1 -1 0\r1 1 0\r-1 1 0\r3 0 1 2\r3 0 2 3\r"},
           {"n.off", "nOFF\n3\n4 2 0\n-1 -1 0\n1 -1 0\n1 1 0\n-1 1 0\n3 0 1 2\n3 0 2 3\n"},
           {"nan.ply",
            "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
            "property float quality\nelement face 2\nproperty list uchar int vertex_indices\nend_header\n"
            "-1 -1 0 nan\n1 -1 0 nan\n1 1 0 inf\n-1 1 0 -inf\n3 0 1 2\n3 0 2 3\n"}}) {
    CAPTURE(name);
    folder.write(name, text);
    CHECK(rendered(folder, in(folder, name) + " --size 8x8")["triangles"] == 2);
  }
  refuses_text(
      "s.ply",
      "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n-1 -1 0\n1 -1 0\n1 1 0\n"
      "-1 1 0\n4 0 1 3 2\n",
      ": has element 'tristrips', which is not read, expected faces");
  refuses_text("d.dxf", "0\nSECTION\n2\nENTITIES\n", ": ends without EOF, expected the whole file");
  refuses_text("g.gltf", R"({"asset": {"version": "2.0"}, "extensionsRequired": ["KHR_mesh_quantization"]})",
               ": requires the extension KHR_mesh_quantization, expected a file without it");
  // A 3DS mesh of four points, whose second face is of a fifth.
  const auto chunk = [](int id, const std::string& inside) {
    std::string text;
    const std::size_t size = inside.size() + 6;
    for (const std::size_t each : {static_cast<std::size_t>(id), size, size >> 16}) {
      text += static_cast<char>(each);
      text += static_cast<char>(each >> 8);
    }
    return text + inside;
  };
  const auto shorts = [](std::initializer_list<int> all) {
    std::string text;
    for (const int each : all) {
      text += static_cast<char>(each);
      text += static_cast<char>(each >> 8);
    }
    return text;
  };
  const std::string points = shorts({4}) + std::string(4 * 12, '\0');
  const auto file = [&](int last) {
    return chunk(
        0x4D4D,
        chunk(0x3D3D,
              chunk(0x4000, std::string("a\0", 2) +
                                chunk(0x4100, chunk(0x4110, points) +
                                                  chunk(0x4120, shorts({2, 0, 1, 2, 0, 0, 1, last, 0}))))));
  };
  refuses_text("t.3ds", file(4), ": vertex 4 does not exist, expected less than 4");
  refuses_text("t.3ds", file(3), ": has no triangle with an area, expected one");
}

TEST_CASE("a scene without highlights has no device and no clock", "[cli][render]") {
  const scratch folder;
  folder.write("dull.json", R"({"mesh": "sphere", "materials": {"*": {"ks": [0, 0, 0]}}})");
  folder.write("dark.json", R"({"mesh": "sphere", "lights": []})");
  for (const char* name : {"dull.json", "dark.json"}) {
    CAPTURE(name);
    const json report = rendered(folder, in(folder, name) + " --engine systemc" + kSmall);
    CHECK(report["device_writes"] == 0);
    CHECK(report["simulated_ns"] == 0);
    CHECK(report["blocks"].empty());
    for (const std::string unit : report["units"]) CHECK(unit.find("specular") == std::string::npos);
    CHECK(report["nmse"].get<double>() < 1e-4);  // nothing but roundings
    const std::string picture = slurp(folder.path("p.png"));
    rendered(folder, in(folder, name) + " --engine systemc --effects all" + kSmall);
    CHECK(slurp(folder.path("p.png")) == picture);
  }
  refuses(folder, in(folder, "dull.json") + " --engine systemc --vcd " + in(folder, "w.vcd"),
          "nothing to record");
}

TEST_CASE("the effect units in hardware change no bit of the picture", "[cli][render]") {
  const scratch folder;
  folder.write("one.json", R"({"mesh": "sphere", "materials": {"*": {"ks": [0.5, 0.5, 0.5]}}})");
  folder.write("three.json", R"({"mesh": "spheres", "lights": [{"direction": [1, 1, 1]},
    {"position": [-4, 5, 3], "colour": [0.6, 0.3, 0.1]}, {"direction": [0, 0, 1], "colour": [0, 0.2, 0]}]})");
  folder.write("dull.json", R"({"mesh": "sphere", "materials": {"*": {"kd": [0, 0, 0], "ks": [0, 0, 0]}}})");
  for (const char* name : {"one.json", "three.json", "dull.json"}) {
    for (const char* shading : {"phong", "gouraud"}) {
      const std::string scene = in(folder, name) + kSmall + "--shading " + shading + " ";
      const json host = rendered(folder, scene, "host.png");
      const std::string picture = slurp(folder.path("host.png"));
      CHECK(host["units_engine"] == "bit");
      CHECK(host["unit_rows"] == 0);
      CHECK(host["cycles"] == 0);
      CHECK(host["blocks"].empty());
      for (const char* options :
           {"--units bit", "--units systemc", "--units verilator", "--units systemc --engine systemc",
            "--units verilator --engine verilator --effects all", "--units systemc --engine verilator",
            "--units systemc --watch 20,18,12,4"}) {
        CAPTURE(name, shading, options);
        const json report = rendered(folder, scene + options);
        CHECK(slurp(folder.path("p.png")) == picture);
        CHECK(report["pixels_in_highlight"] == host["pixels_in_highlight"]);
        if (std::string(options).find("all") == std::string::npos) CHECK(report["units"] == host["units"]);
        const bool is_hardware = std::string(options) != "--units bit";
        CHECK((report["unit_rows"] >= report["points"]) == is_hardware);
        CHECK((report["unit_cycles"] > report["unit_rows"]) == is_hardware);
        CHECK(report["cycles"] >= report["unit_cycles"]);
        CHECK(report["simulated_ns"] == 10 * report["cycles"].get<int>());
        const bool has_systemc = std::string(options).find("systemc") != std::string::npos;
        CHECK((report["blocks"].size() > 20) == has_systemc);
      }
    }
  }
  const std::string segments = std::string("teapot --renderer segments") + kSmall;
  rendered(folder, segments, "host.png");
  rendered(folder, segments + "--units systemc --engine systemc");
  CHECK(slurp(folder.path("p.png")) == slurp(folder.path("host.png")));
}

TEST_CASE("an energy factor is the same on the host and in hardware", "[cli][render]") {
  const scratch folder;
  folder.write("three.json",
               R"({"mesh": "spheres", "normalisation": "blinn", "lights": [{"direction": [1, 1, 1]},
    {"position": [-4, 5, 3], "colour": [0.6, 0.3, 0.1]}]})");
  const std::string plain_scene = std::string("spheres") + kSmall;
  const json plain = rendered(folder, plain_scene, "plain.png");
  CHECK(plain["normalisation"] == "none");
  rendered(folder, plain_scene + "--normalisation none");
  CHECK(slurp(folder.path("p.png")) == slurp(folder.path("plain.png")));
  for (const std::string& scene :
       {in(folder, "three.json") + kSmall, plain_scene + "--normalisation thesis "}) {
    const json host = rendered(folder, scene, "host.png");
    const std::string picture = slurp(folder.path("host.png"));
    CHECK(picture != slurp(folder.path("plain.png")));
    CHECK(host["normalisation"] == (scene.find("thesis") != std::string::npos ? "thesis" : "blinn"));
    CHECK(host["nmse"].get<double>() < 0.05);  // against Blinn's picture with the factor
    CHECK(std::ranges::count(host["units"], "energy") == 1);
    for (const char* options :
         {"--effects all", "--units systemc", "--units systemc --engine verilator", "--units verilator",
          "--units verilator --engine verilator --format q16",
          "--units systemc --engine systemc --effects all", "--watch 20,18,12,4", "--threads 3"}) {
      CAPTURE(scene, options);
      const json report = rendered(folder, scene + options);
      CHECK(slurp(folder.path("p.png")) == picture);
      CHECK(report["nmse"] == host["nmse"]);
    }
  }
  CHECK(run_blysk(folder, "render sphere --explain --normalisation thesis")
            .out.find("; energy factor 2.28106") != std::string::npos);
  for (const char* format : {"q8", "q10", "q24"}) {
    const std::string scene = fmt::format("sphere {} --normalisation blinn --format {} ", kSmall, format);
    rendered(folder, scene, "host.png");
    const json report = rendered(folder, scene + "--units verilator");
    CHECK(slurp(folder.path("p.png")) == slurp(folder.path("host.png")));
    CHECK(report["unit_cycles"] > report["unit_rows"]);
  }
  refuses(folder, "sphere --normalisation most",
          "normalisation most does not exist, expected none, thesis, blinn");
  refuses(folder, "sphere --normalisation blinn --as-published",
          "expected a device with options that limit it to 255");
}

TEST_CASE("lines of Gouraud's shading by a device are the same in every engine", "[cli][render]") {
  const scratch folder;
  const std::string scene = std::string("torus --shading gouraud") + kSmall;
  const json host = rendered(folder, scene, "host.png");
  CHECK(host["spans_engine"] == "host");
  CHECK(host["span_lines"] == 0);
  const json model = rendered(folder, scene + "--spans bit", "bit.png");
  const std::string picture = slurp(folder.path("bit.png"));
  CHECK(picture != slurp(folder.path("host.png")));
  CHECK(model["cycles"] == 0);
  CHECK(model["nmse"].get<double>() == Approx(host["nmse"].get<double>()).epsilon(0.05));
  for (const char* options :
       {"--spans systemc", "--spans verilator", "--spans systemc --engine systemc --units systemc",
        "--spans systemc --engine verilator --threads 3"}) {
    CAPTURE(options);
    const json report = rendered(folder, scene + options);
    CHECK(slurp(folder.path("p.png")) == picture);
    CHECK(report["span_lines"] == model["span_lines"]);
    CHECK(report["cycles"] > report["span_lines"]);
    const bool has_processes = std::string(options).find("systemc") != std::string::npos;
    CHECK((report["process_runs"] > report["cycles"]) == has_processes);
  }
  CHECK(model["span_lines"] > 100);
  refuses(folder, "sphere --spans bit", "expected shading gouraud");
  refuses(folder, "sphere --spans golden --shading gouraud", "--spans");
}

TEST_CASE("the runs of processes are counted where there are any", "[cli][render]") {
  const scratch folder;
  const std::string scene = std::string("sphere") + kSmall;
  CHECK(rendered(folder, scene)["process_runs"] == 0);
  const json one = rendered(folder, scene + "--engine systemc");
  const json off = rendered(folder, scene + "--engine systemc --process-runs off");
  CHECK(off["process_runs"] == 0);
  CHECK(off["delta_cycles"] == one["delta_cycles"]);
  const json both = rendered(folder, scene + "--engine systemc --units systemc");
  CHECK(rendered(folder, scene + "--units systemc")["process_runs"] > 0);
  CHECK(rendered(folder, scene + "--watch highlight")["process_runs"] > 0);
  // Hosts and clocks are none of the device's blocks.
  CHECK(both["blocks"].size() > one["blocks"].size() + 20);
  for (const std::string block : both["blocks"]) {
    CAPTURE(block);
    CHECK(block.find("host") == std::string::npos);
    CHECK(std::ranges::count(both["blocks"], json(block)) == 1);
  }
  // A write takes two cycles: four edges of the clock, and more than one block runs after each of two.
  const auto runs = one["process_runs"].get<std::uint64_t>();
  CHECK(runs > 2 * one["cycles"].get<std::uint64_t>() + one["device_writes"].get<std::uint64_t>() * 4);
  CHECK(runs > one["delta_cycles"].get<std::uint64_t>());
  CHECK(runs < 10 * one["delta_cycles"].get<std::uint64_t>());
  CHECK(both["process_runs"].get<std::uint64_t>() > 2 * runs);
  // Nothing is different without the report.
  const outcome shown =
      run_blysk(folder, "render " + scene + "--engine systemc --output " + in(folder, "q.png"));
  CHECK(slurp(folder.path("q.png")) == slurp(folder.path("p.png")));
  CHECK(shown.out.find("delta cycles\n") != std::string::npos);
  const outcome counted =
      run_blysk(folder, "render " + scene + "--engine systemc --report " + in(folder, "q.json"));
  CHECK(counted.out.find(fmt::format("{} delta cycles, {} runs of processes\n",
                                     one["delta_cycles"].get<std::uint64_t>(), runs)) != std::string::npos);
}

TEST_CASE("a grey scene takes fewer runs of processes than a coloured one", "[cli][render]") {
  const scratch folder;
  folder.write("coloured.json", R"({"mesh": "sphere", "materials": {"*": {"n": 10}}})");
  folder.write("grey.json", R"({"mesh": "sphere",
    "materials": {"*": {"n": 10, "ka": [0.5, 0.5, 0.5], "kd": [0.5, 0.5, 0.5], "ks": [0.75, 0.75, 0.75]}}})");
  const auto runs_of = [&](const std::string& name) {
    const std::string scene = in(folder, name) + kSmall + "--engine systemc --units systemc ";
    const json report = rendered(folder, scene);
    const std::string picture = slurp(folder.path("p.png"));
    rendered(folder, scene + "--effects all");
    CHECK(slurp(folder.path("p.png")) == picture);
    return report["process_runs"].get<double>();
  };
  CHECK(runs_of("coloured.json") > 1.3 * runs_of("grey.json"));
}

TEST_CASE("the waves of the effect units are those of what is watched", "[cli][render]") {
  const scratch folder;
  const std::string scene = std::string("sphere") + kSmall + "--units systemc ";
  const auto waves_of = [&](const std::string& options) {
    rendered(folder, scene + options + "--units-vcd " + in(folder, "u.vcd"));
    return slurp(folder.path("u.vcd"));
  };
  const std::string few = waves_of("--watch 24,24,4,1 --vcd " + in(folder, "w.vcd") + " ");
  const std::string all = waves_of("");
  for (const std::string& each : {few, all}) {
    CHECK(each.find("n_l") != std::string::npos);
    CHECK(each.find("red_sum_real") != std::string::npos);
    CHECK(each.find("$enddefinitions") != std::string::npos);
  }
  CHECK(all.size() > 10 * few.size());
  CHECK(slurp(folder.path("w.vcd")).find("cos18") != std::string::npos);
  fs::remove(folder.path("u.vcd"));
  fs::remove(folder.path("w.vcd"));
  fs::remove(folder.path("p.png"));
  fs::remove(folder.path("r.json"));
  refuses(folder, "sphere --units verilator --units-vcd " + in(folder, "u.vcd"), "expected --units systemc");
  refuses(folder, "sphere --units-vcd " + in(folder, "u.vcd"), "expected --units systemc");
  refuses(folder, "sphere --units systemc --engine golden", "expected bit, systemc or verilator");
  refuses(folder, "sphere --units golden", "--units");
  refuses(folder, "sphere --units systemc --as-published", "takes specular terms of UQ8.16");
  refuses(folder, "sphere --units systemc --animate 2 --units-vcd " + in(folder, "u.vcd"),
          "expected no --units-vcd");
}

TEST_CASE("the plan says what is computed and why", "[cli][render]") {
  const scratch folder;
  const outcome run = run_blysk(folder, "render sphere --explain --format q8");
  CHECK(run.status == 0);
  CHECK(run.out.find("units: ambient, diffuse, specular, " + top_of("q8") + ", saturation\n") !=
        std::string::npos);
  CHECK(run.out.find("n = 50, a write where N.L > 0, N.V > 0 and cos >= 0.9") != std::string::npos);
  CHECK(run.out.find("register 1 is written once: n = 50 everywhere") != std::string::npos);
  CHECK(folder.names().empty());
}

TEST_CASE("whole triangles are left out unless it is asked otherwise", "[cli][render]") {
  const scratch folder;
  const std::string scene = "sphere --density 6 --size 64x64 ";
  const json on = rendered(folder, scene);
  const std::string picture = slurp(folder.path("p.png"));
  CHECK(on["triangles_left_out"] > 0);
  CHECK(on["tests_left_out"] > 0);
  const json off = rendered(folder, scene + "--inner-check off");
  CHECK(off["triangles_left_out"] == 0);
  CHECK(off["tests_left_out"] == 0);
  CHECK(off["device_writes"] == on["device_writes"]);
  CHECK(slurp(folder.path("p.png")) == picture);
  const auto explained = [&](const std::string& options) {
    return run_blysk(folder, "render sphere --explain " + options).out;
  };
  CHECK(explained("").find("inner specular check on: ") != std::string::npos);
  CHECK(explained("--inner-check off").find("inner specular check off, as asked") != std::string::npos);
  CHECK(explained("--shading gouraud").find("inner specular check off: ") != std::string::npos);
  refuses(folder, "sphere --inner-check maybe", "--inner-check");
}

TEST_CASE("segments are another renderer", "[cli][render]") {
  const scratch folder;
  const std::string scene = "teapot --density 4 --size 64x48 ";
  const json whole = rendered(folder, scene);
  CHECK(!whole.contains("segments"));
  const std::string picture = slurp(folder.path("p.png"));
  const json rays = rendered(folder, scene + "--renderer segments --segment 1 --engine systemc");
  CHECK(slurp(folder.path("p.png")) == picture);
  CHECK(rays["segments"]["pixels_traced"] == 64 * 48);
  CHECK(rays["points"] == whole["points"]);  // the rays that meet the mesh
  CHECK(rays["segments"]["elements_2_29"] == 65 * 48);
  const json some = rendered(folder, scene +
                                         "--renderer segments --segment-limit 5 --segment-measure rgb "
                                         "--segment-inner cubic");
  CHECK(some["segments"]["pixels_traced"] < 64 * 48);
  CHECK(some["segments"]["pixels_traced"].get<int>() + some["segments"]["pixels_interpolated"].get<int>() ==
        64 * 48);
  CHECK(some["segments"]["elements_2_29"] == 9 * 48);
  CHECK(some["device_writes"] < whole["device_writes"]);
  refuses(folder, scene + "--renderer segments --shading flat", "expected shading phong and no --watch");
  refuses(folder, scene + "--renderer segments --watch 1,1", "expected shading phong and no --watch");
  const json blocks = rendered(folder, scene + "--renderer segments --segment-inner bilinear");
  CHECK(blocks["segments"]["pixels_traced"] < 64 * 48);
  CHECK(blocks["segments"]["elements_2_29"] == 9 * 7);
  rendered(folder, scene + "--renderer segments --segment-inner bilinear --segment 1");
  CHECK(slurp(folder.path("p.png")) == picture);
  refuses(folder, scene + "--renderer segments --segment-inner biquadratic", "--segment-inner");
  refuses(folder, scene + "--renderer segments --segment 0", "--segment");
  refuses(folder, scene + "--renderer segments --segment-limit nan", "--segment-limit");
  refuses(folder, scene + "--renderer segments --segment-measure lab", "--segment-measure");
}

TEST_CASE("an OBJ file of one's own is one command", "[cli][render]") {
  const scratch folder;
  folder.write("own.mtl", "newmtl red\nKd 0.5 0.1 0.1\nKs 0.5\nNs 35.999996\n");
  folder.write("own.obj", "mtllib own.mtl\n" + kTriangle + "usemtl red\nf 1 2 3\n");
  const json report = rendered(folder, in(folder, "own.obj") + " --size 40x30");
  CHECK(report["triangles"] == 1);
  CHECK(report["width"] == 40);
  REQUIRE(report["messages"].size() == 2);
  CHECK(report["messages"][0] ==
        "material 'red': illum absent, 2 taken since Ks > 0; Ns 35.999996 rounded to 36");
  // A library is read to its end: not one that has none.
  folder.write("zeros.obj", "mtllib ../../../../../../../../dev/zero\n" + kTriangle + "f 1 2 3\n");
  const json plain = rendered(folder, in(folder, "zeros.obj") + " --size 40x30");
  CHECK(std::string(plain["messages"][0]).find("is no regular file, expected a library of materials") !=
        std::string::npos);
}

TEST_CASE("a scene file gives what the command line does not", "[cli][render]") {
  const scratch folder;
  folder.write("own.obj", kTriangle + "f 1 2 3\n");
  folder.write(
      "s.json",
      R"({"mesh": "own.obj", "size": [20, 10], "shading": "flat", "format": "q12", "engine": "golden",
    "lights": [{"direction": [0, 0, 1]}, {"position": [0, 0, 5], "colour": [1, 0, 0]}],
    "ambient": [0, 0, 0], "background": [0, 0, 1], "camera": {"eye": [0, 0, 4], "target": [0, 0, 0], "fov": 60},
    "materials": {"plain": {"n": 7}}})");
  json report = rendered(folder, in(folder, "s.json"));
  CHECK(report["width"] == 20);
  CHECK(report["shading"] == "flat");
  CHECK(report["format"] == "q12");
  CHECK(report["engine"] == "golden");
  CHECK(report["lights"] == 2);
  report = rendered(folder, in(folder, "s.json") + " --size 8x8 --engine bit --light 1,1,1 --shading phong");
  CHECK(report["width"] == 8);
  CHECK(report["engine"] == "bit");
  CHECK(report["lights"] == 1);
  CHECK(report["shading"] == "phong");
}

TEST_CASE("a direction is one however short", "[cli][render]") {
  const scratch folder;
  const auto made = [&](const std::string& arguments) {
    const outcome done = run_blysk(folder, "render --size 16x16 --output - " + arguments);
    CAPTURE(arguments, done.err);
    REQUIRE(done.status == 0);
    return done.out;
  };
  const std::string expected = made("sphere --light 1,0,2");
  CHECK(made("sphere --light 1e-200,0,2e-200") == expected);
  for (const std::string scale : {"", "e-200"}) {
    folder.write("a.json",
                 R"({"mesh": "sphere", "lights": [{"direction": [1)" + scale + ", 0, 2" + scale + "]}]}");
    CHECK(made(in(folder, "a.json")) == expected);
  }
}

TEST_CASE("a number too small for a double is 0", "[cli][render]") {
  const scratch folder;
  rendered(folder, "sphere --size 8x8 --ambient 1e-400,+.5,0 --light 1e-400,0,1");
}

TEST_CASE("a picture has no name of another form", "[cli][render]") {
  const scratch folder;
  for (const std::string name : {"x.jpg", "x.PPM", "x.gif"}) {
    const outcome failed =
        run_blysk(folder, "render sphere --size 8x8 --output " + quoted(folder.path(name)));
    CHECK(failed.status == 2);
    CHECK(failed.err.ends_with(name + ": names another form of picture, expected .png\n"));
  }
  CHECK(folder.names().empty());
}

TEST_CASE("bad use is one line, and no file is written", "[cli][render]") {
  const scratch folder;
  const std::vector<std::pair<std::string, std::string>> cases{
      {"nosuch", "nosuch: does not exist, expected sphere, teapot, torus, spheres, or a file"},
      {"/", "is a directory, expected a file"},
      {"sphere --size 0x5", "--size is 0x5, expected WIDTHxHEIGHT"},
      {"sphere --size 5", "--size is '5', expected WIDTHxHEIGHT"},
      {"sphere --size 99999x5", "expected WIDTHxHEIGHT, each 1 to 16384"},
      {"sphere --engine nosuch", "engine nosuch does not exist, expected golden, bit, systemc, verilator"},
      {"sphere --device nosuch", "nosuch"},
      {"sphere --shading nosuch", "shading nosuch does not exist, expected flat, gouraud, polynomial, phong"},
      {"sphere --perspective nosuch", "perspective nosuch does not exist, expected corrected or screen"},
      {"sphere --effects some", "--effects"},
      {"sphere --light 1,2", "--light is '1,2', expected X,Y,Z"},
      {"sphere --light 0,0,0", "--light is 0,0,0, expected a direction"},
      {"sphere --fov nan", "--fov: is 'nan', expected a number from 0.001 to 179"},
      {"sphere --light nan,0,0", "expected at most"},
      {"sphere --light 1,1,1,2,0,0", "expected R,G,B, each in [0, 1]"},
      {"sphere --ambient 1,1", "--ambient is '1,1', expected R,G,B"},
      {"sphere --eye 0,0,0 --target 0,0,0", "camera: eye and target are one place, expected two"},
      {"sphere --eye 0,9,0 --target 0,0,0", "camera: up points where the camera looks"},
      {"sphere --fov 180", "--fov"},
      {"sphere --segment 4", "--segment is about segments, expected --renderer segments"},
      {"sphere --renderer z-buffer --segment-inner cubic", "--segment-inner is about segments"},
      {"sphere --compare y.JPG", "y.JPG: names another form of picture, expected .png"},
      {"sphere --exponent 1001", "--exponent"},
      {"sphere --density 1", "--density"},
      {"sphere --watch 600,0", "--watch is 600,0, expected pixels of a picture of 512 x 512"},
      {"sphere --watch x", "--watch is 'x', expected highlight, X,Y"},
      {"sphere --watch 1,1 --engine golden", "expected an engine of the same numbers"},
      {"sphere --vcd w.vcd", "expected --watch or engine systemc"},
  };
  for (const auto& [arguments, part] : cases) refuses(folder, arguments, part);
  for (const std::string option :
       {"--animate 3", "--engine systemc --vcd w.vcd", "--watch 1,1", "--units systemc --units-vcd u.vcd"}) {
    const outcome unused = run_blysk(folder, "render sphere --size 8x8 --explain " + option);
    CAPTURE(option, unused.err);
    CHECK(unused.status == 2);
    CHECK(unused.out.empty());
    CHECK(unused.err.find(" is of a picture, expected --output") != std::string::npos);
  }
  const outcome nothing = run_blysk(folder, "render sphere");
  CHECK(nothing.status == 2);
  CHECK(nothing.err.find("nothing to do, expected --output, --report, --compare or --explain") !=
        std::string::npos);
  refuses(folder, "sphere --compare " + in(folder, "x.png"), "--output and --compare");
}

TEST_CASE("a bad scene is one line that names file and line", "[cli][render]") {
  const scratch folder;
  const auto refuses_text = [&](const std::string& name, const std::string& text, const std::string& part) {
    folder.write(name, text);
    refuses(folder, in(folder, name), folder.path(name) + part);
  };
  refuses_text("a.obj", "", ": has no triangle with an area, expected one");
  refuses_text("a.obj", kTriangle + "f 1 2 4\n", ":4: vertex '4' does not exist, expected 1 to 3");
  refuses_text("a.obj", kTriangle + "f 1 2 -4\n", ":4: vertex '-4' does not exist, expected 1 to 3");
  refuses_text("a.obj", kTriangle + "f 1//1 2//1 3//1\n", ":4: normal '1' does not exist, expected 1 to 0");
  refuses_text("a.obj", kTriangle + "f 1 2\n", ":4: face has 2 corners, expected three or more");
  refuses_text("a.obj", "v 0 0 nan\n", ":1: vertex has 'nan', expected three numbers");
  refuses_text("a.obj", "v 0 0 1e31\n", ":1: vertex has 1e31, expected at most 1e+30");
  refuses_text("a.obj", "v 0 0 0\nv 1e-101 0 0\nv 0 1e-101 0\nf 1 2 3\n",
               ": is too small, expected an extent of at least 1e-100");
  refuses_text("a.obj", "v 0 0\n", ":1: vertex has '', expected three numbers");
  refuses_text("a.obj", kTriangle + "f 1 1 2\n", ": has no triangle with an area, expected one");
  refuses_text("a.obj", std::string("v 0 0 1\n\0\n", 10), ":2: holds a zero byte, expected text");
  refuses_text("a.json", "{", ":1: is no JSON here, expected a scene");
  refuses_text(
      "a.json", "{",
      ":1: is no JSON here, expected a scene as docs/scenes.md has it; column 2 has the end of the file");
  refuses_text("a.json", "{\n\"mesh\": \"sphere\",\n\"x\": }", ":3: is no JSON here");
  refuses_text("a.json", "{\n\"mesh\": \"sphere\",\n}",
               ":3: is no JSON here, expected a scene as docs/scenes.md has it; column 1 has '}'");
  refuses_text("a.json", R"({"mesh": "sphere", "mesh": "torus"})",
               ":1: has 'mesh' twice in one object, expected it once");
  refuses_text("a.json", R"({"mesh": "sphere", "lights": [{"position": [1, 1, 1], "position": [2, 2, 2]}]})",
               ":1: has 'position' twice in one object, expected it once");
  // Deeper than any stack.
  refuses_text(
      "a.json",
      R"({"mesh": "sphere", "density": )" + std::string(200'000, '[') + std::string(200'000, ']') + "}",
      ":1: density: is an array, expected a number in [2, ");
  refuses_text("a.json", R"({"mesh": "sphere", ")" + std::string(100'000, 'x') + "\": 1}",
               ":1: the file: has '" + std::string(40, 'x') + "...', expected mesh");
  refuses_text("a.json", R"({"mesh": "sphere", "density": ")" + std::string(100'000, 'x') + "\"}",
               ":1: density: is \"" + std::string(39, 'x') + "..., expected a number in [2, ");
  refuses_text("a.json", R"({"mesh": "sphere", "density": 1})",
               ":1: density: is 1, expected a number in [2, 1000]");
  refuses_text("a.json", R"({"mesh": 1e999})", ":1: has a number beyond 1.8e308, expected a scene");
  refuses_text("a.json", "{\n\"mesh\": \"sphere\",\n\"ambient\": [0,\n0,\n2\n]}",
               ":5: ambient[2]: is 2, expected a number in [0, 1]");
  refuses_text("a.json", "{\"mesh\": \"sphere\",\n\"lights\": [{\"direction\": [1, 1, 1]},\n{\"color\": 1}]}",
               ":3: lights[1]: has 'color', expected direction, position, colour");
  refuses_text("a.json", "{\"mesh\": \"sphere\",\n\"materials\": {\"*\": {\"n\":\n1.5}}}",
               ":2: materials.*.n: is 1.5, expected an integer");
  refuses_text("a.json", "[]", ":1: the file: is array, expected an object");
  refuses_text("a.json", R"({"lights": []})", ":1: the file: has no mesh, expected its name");
  refuses_text("a.json", R"({"mesh": "sphere", "lamps": []})",
               ":1: the file: has 'lamps', expected mesh, density");
  refuses_text("a.json", R"({"mesh": "sphere", "lights": [{}]})",
               ":1: lights[0]: has neither direction nor position");
  refuses_text("a.json", R"({"mesh": "sphere", "lights": [{"direction": [0, 0, 0]}]})",
               ":1: lights[0].direction: is zero, expected a direction");
  refuses_text("a.json", R"({"mesh": "sphere", "ambient": [0, 0, 2]})",
               ":1: ambient[2]: is 2, expected a number in [0, 1]");
  refuses_text("a.json", R"({"mesh": "sphere", "materials": {"x": {}}})",
               ":1: materials: has 'x', expected *, plain");
  refuses_text("a.json", R"({"mesh": "sphere", "materials": {"*": {"n": 1.5}}})",
               ":1: materials.*.n: is 1.5, expected an integer");
  refuses_text("a.json", R"({"mesh": "a.json"})", ":1: mesh: is a scene, expected a mesh");
  refuses_text("a.json", R"({"mesh": "sphere", "camera": {"eye": [0, 0, 0], "target": [0, 0, 0]}})",
               ":1: camera: eye and target are one place, expected two");
  refuses_text("a.json", R"({"mesh": "sphere\u0000.obj"})", ":1: mesh: holds a zero byte, expected text");
  refuses_text("a.json", R"({"x\u0000y": 1})", R"(:1: the file: has 'x\x00y', expected mesh)");
  folder.write("a.json", R"({"mesh": ")" + std::string(300, 'x') + "\"}");
  refuses(folder, in(folder, "a.json"),
          "...: cannot be read (File name too long), expected a shape or a file");
  refuses_text("a.ply", "ply\nformat ascii 1.0\n", ": ");
  refuses_text("a.3ds", "nothing", ": cannot be read (");
  refuses(folder, std::string(300, 'x'),
          "xxx...: cannot be read (File name too long), expected a shape or a file");
  folder.write("a.mtl", "newmtl a\nNs nan\n");
  folder.write("b.obj", "mtllib a.mtl\n" + kTriangle + "usemtl a\nf 1 2 3\n");
  refuses(folder, in(folder, "b.obj"), "a.mtl:2: Ns is 'nan', expected a number");
  folder.write("c.obj", kTriangle + "f 1 2 3\n");
  refuses(folder, in(folder, "c.obj") + " --density 9",
          "c.obj: is a mesh from a file, expected --density with a built-in shape only");
  refuses_text("a.json", R"({"mesh": "c.obj", "density": 9})", ":1: density: is of a built-in shape");
}

TEST_CASE("two results do not go into one standard output", "[cli][render]") {
  const scratch folder;
  for (const char* names : {"--output - --report -", "--output /dev/stdout --report -",
                            "--output /dev/fd/1 --report /proc/self/fd/1"}) {
    CAPTURE(names);
    const outcome run = run_blysk(folder, std::string("render sphere ") + kSmall + names);
    CHECK(run.status == 2);
    CHECK(run.out.empty());
    CHECK(run.err.find("is given by --output and --report, expected different files") != std::string::npos);
  }
}

TEST_CASE("files that cannot be written leave nothing behind", "[cli][render]") {
  const scratch folder;
  fs::create_directory(folder.path("taken"));
  const std::string small = std::string("render sphere --engine systemc") + kSmall;
  const auto fails = [&](const std::string& arguments, const std::string& part,
                         const std::string& first = "") {
    const outcome run = run_blysk(folder, small + arguments, first);
    CAPTURE(arguments, run.err);
    CHECK(run.status == 2);
    CHECK(run.err.find(part) != std::string::npos);
    CHECK(std::count(run.err.begin(), run.err.end(), '\n') == 1);
    CHECK(folder.names() == std::vector<std::string>{"taken"});
  };
  const std::string picture = "--output " + in(folder, "p.png");
  fails("--output " + in(folder, "taken"), "is a directory, expected a file");
  fails(picture + " --report " + in(folder, "taken"), "is a directory, expected a file");
  fails(picture + " --vcd " + in(folder, "taken"), "is a directory, expected a file");
  fails(picture + " --report " + in(folder, "no/r.json"), "cannot be");
  fails(picture + " --vcd " + in(folder, "w.vcd"), "cannot be written", "trap '' XFSZ; ulimit -f 2; ");
}

TEST_CASE("the frames of a turning object", "[cli][render]") {
  const scratch folder;
  const std::string scene = std::string("teapot --engine systemc") + kSmall;
  const outcome run = run_blysk(folder, fmt::format("render {} --animate 4 --output {} --report {}", scene,
                                                    in(folder, "a%d.png"), in(folder, "r.json")));
  CAPTURE(run.err);
  REQUIRE(run.status == 0);
  const auto frame = [&](int number) { return slurp(folder.path(fmt::format("a%d-{:04}.png", number))); };
  const json report = json::parse(slurp(folder.path("r.json")));
  REQUIRE(report.size() == 4);
  for (int number = 1; number <= 4; ++number) {
    CAPTURE(number);
    CHECK(frame(number).starts_with("\x89PNG"));
    for (int other = 1; other < number; ++other) CHECK(frame(number) != frame(other));
    CHECK(report[static_cast<std::size_t>(number - 1)].at("device_writes") > 0);
  }
  // Each has its own counts: those of frames before are none of it.
  for (const char* key : {"cycles", "simulated_ns", "delta_cycles", "process_runs"}) {
    CAPTURE(key, report[0][key], report[3][key]);
    double sum = 0;
    for (const json& each : report)
      sum += each.at(key).get<double>() / each.at("device_writes").get<double>();
    CHECK(report[3].at(key).get<double>() / report[3].at("device_writes").get<double>() < sum / 2);
  }
  // The first is the still picture; half a turn is that of two frames.
  rendered(folder, scene);
  CHECK(frame(1) == slurp(folder.path("p.png")));
  REQUIRE(run_blysk(folder, fmt::format("render {} --animate 2 --output {}", scene, in(folder, "b.png")))
              .status == 0);
  CHECK(slurp(folder.path("b-0002.png")) == frame(3));
}

TEST_CASE("bad use of an animation is one line, and no file is written", "[cli][render]") {
  const scratch folder;
  const std::string scene = std::string("sphere") + kSmall;
  refuses(folder, scene + "--animate 0", "--animate");
  refuses(folder, scene + "--animate 10000", "--animate");
  refuses(folder, scene + "--animate 0x2", "--animate: is '0x2', expected a whole number from 1 to 9999");
  refuses(folder, scene + "--threads ' 2'", "--threads: is ' 2', expected a whole number from 1 to 256");
  refuses(folder, scene + "--animate 2 --watch highlight", "expected no --watch, --vcd or --compare");
  refuses(folder, scene + "--film " + in(folder, "f.gif"), "expected --animate N");
  refuses(folder, scene + "--animate 2 --film " + in(folder, "f.avi"),
          "expected a name that ends with .mp4, .webm or .gif");
  const outcome nothing =
      run_blysk(folder, fmt::format("render {} --animate 2 --output {}", scene, in(folder, "x.jpg")));
  CHECK(nothing.status == 2);
  CHECK(nothing.err.find("expected a name that ends with .png") != std::string::npos);
  const outcome bare = run_blysk(folder,
                                 fmt::format("render {} --animate 2 --output {} --film {}", scene,
                                             in(folder, "x.png"), in(folder, "f.gif")),
                                 "PATH=/nonexistent; ");
  CHECK(bare.status == 2);
  CHECK(bare.err.find("--film wants ffmpeg or ImageMagick, which is not installed") != std::string::npos);
  CHECK(folder.names().empty());
  // A program that makes no film leaves the frames and their report.
  fs::create_directory(folder.path("bin"));
  fs::permissions(folder.write("bin/ffmpeg", "#!/bin/sh\nexit 1\n"), fs::perms::owner_all);
  const outcome failed =
      run_blysk(folder,
                fmt::format("render {} --animate 2 --output {} --film {} --report {}", scene,
                            in(folder, "x.png"), in(folder, "f.gif"), in(folder, "r.json")),
                "PATH=" + folder.path("bin") + ":$PATH; ");
  CAPTURE(failed.err);
  CHECK(failed.status == 2);
  CHECK(failed.err.find("f.gif: cannot be made") != std::string::npos);
  CHECK(json::parse(slurp(folder.path("r.json"))).size() == 2);
}

TEST_CASE("a film is made of the frames", "[cli][render]") {
  const scratch folder;
  if (std::system("command -v ffmpeg >/dev/null") != 0) {
    WARN("ffmpeg is not installed: not tried");
    return;
  }
  // Of a longer run before: the film has none of it.
  folder.write("f-0004.png", "no picture");
  for (const std::string ending : {"mp4", "gif"}) {
    CAPTURE(ending);
    const outcome run = run_blysk(
        folder, fmt::format("render sphere --size 33x31 --density 12 --animate 3 --output {} --film {}",
                            in(folder, "f.png"), in(folder, "f." + ending)));
    CAPTURE(run.err);
    REQUIRE(run.status == 0);
    const std::string film = slurp(folder.path("f." + ending));
    CHECK((ending == "gif" ? film.starts_with("GIF8") : film.substr(4, 4) == "ftyp"));
  }
}
