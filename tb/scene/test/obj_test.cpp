// SPDX-License-Identifier: Apache-2.0
// OBJ and MTL: what files in the wild do to readers.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "tb/catch.h"
#include "tb/scene/obj_reader.h"
#include "tb/scene/text_lines.h"
#include "tb/usage_error.h"

namespace {

using namespace blysk;
using namespace blysk::scene;

struct read_file_of_test {
  mesh of;
  std::vector<std::string> messages;
};

const std::string kSquare = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

read_file_of_test read(const std::string& obj, const std::map<std::string, std::string>& files = {}) {
  read_file_of_test made;
  const auto open = [&](const std::string& name) {
    const auto found = files.find(name);
    if (found == files.end()) throw file_error(name, 0, "cannot be read");
    return library_text{name, found->second};
  };
  made.of = read_obj("a.obj", decoded("a.obj", obj), open, made.messages);
  return made;
}

/// What the one material of the text becomes.
material material_of(const std::string& mtl, std::vector<std::string>* messages = nullptr) {
  auto made = read("mtllib m\nusemtl a\n" + kSquare + "f 1 2 3\n", {{"m", "newmtl a\n" + mtl}});
  if (messages != nullptr) *messages = made.messages;
  for (const material& each : made.of.materials) {
    if (each.name == "a") return each;
  }
  FAIL("no material");
  return {};
}

std::string message_of(const std::string& mtl) {
  std::vector<std::string> messages;
  material_of(mtl, &messages);
  for (const std::string& each : messages) {
    if (each.starts_with("material 'a': ")) return each.substr(14);
  }
  return "";
}

std::string refusal_of(const std::string& obj, const std::map<std::string, std::string>& files = {}) {
  try {
    read(obj, files);
  } catch (const usage_error& error) {
    return error.what();
  }
  return "";
}

std::string as_utf16(const std::string& text, bool big_endian) {
  std::string bytes = big_endian ? "\xFE\xFF" : "\xFF\xFE";
  for (const char each : text) bytes += big_endian ? std::string{'\0', each} : std::string{each, '\0'};
  return bytes;
}

double area_of(const mesh& of) {
  double sum = 0;
  for (const triangle& each : of.triangles) {
    const vec& a = of.positions[each.position[0]];
    const vec twice = cross(of.positions[each.position[1]] - a, of.positions[each.position[2]] - a);
    sum += std::sqrt(golden::dot(twice, twice)) / 2;
  }
  return sum;
}

TEST_CASE("numbers of a material are made legal, and every change is said", "[scene]") {
  CHECK(message_of("Kd 1 0 0\n").empty());
  CHECK(material_of("Kd 1 0 0\n").kd == rgb{1, 0, 0});
  // illum absent is not 0.
  CHECK(message_of("Ks 1 1 1\nNs 50\n") == "illum absent, 2 taken since Ks > 0");
  CHECK(material_of("Ks 1 1 1\nNs 50\n").ks == rgb{1, 1, 1});
  CHECK(material_of("Ks 1 1 1\nNs 50\n").n == 50);
  CHECK(message_of("illum 2\nKs 1 1 1\nNs 50\n").empty());
  CHECK(material_of("illum 1\nKs 1 1 1\nNs 50\n").ks == rgb{0, 0, 0});
  CHECK(message_of("illum 1\nKs 1 1 1\nNs 50\n").empty());
  CHECK(material_of("illum 0\nKd 1 0.5 0\nKa 1 1 1\n").emitted == rgb{1, 0.5, 0});
  CHECK(material_of("illum 0\nKd 1 0.5 0\nKa 1 1 1\n").kd == rgb{0, 0, 0});
  CHECK(material_of("illum 0\nKd 1 0.5 0\nKa 1 1 1\n").ka == rgb{0, 0, 0});
  CHECK(message_of("illum 7\nKd 1 0 0\n") == "illum 7 taken as 2");
  // One number is grey.
  CHECK(material_of("illum 2\nNs 1\nKs .5\n").ks == rgb{0.5, 0.5, 0.5});
  CHECK(message_of("illum 2\nNs 1\nKs -1 1e400 0.5\n") == "Ks -1 inf 0.5 cut to 0 1 0.5");
  CHECK(message_of("illum 2\nNs 1\nKs 1e-400 0 1\n").empty());
  const std::vector<std::pair<std::string, std::string>> exponents{
      {"0", "Ns 0 cut to 1"},
      {"0.75", "Ns 0.75 cut to 1"},
      {"35.999996", "Ns 35.999996 rounded to 36"},
      {"96.078431", "Ns 96.078431 rounded to 96"},
      {"1000.4", "Ns 1000.4 cut to 1000"},
      {"1e39", "Ns 1e+39 cut to 1000"},
      {"1e400", "Ns inf cut to 1000"},
      {"-3", "Ns -3 cut to 1"},
      {"900", ""}};
  for (const auto& [text, said] : exponents)
    CHECK(message_of("illum 2\nKs 1 1 1\nNs " + text + "\n") == said);
  CHECK(message_of("illum 2\nKs 1 1 1\n") == "Ns absent, 1 taken");
  CHECK(message_of("Kd 1 0 0\nmap_Kd a b.png\n") == "map_Kd dropped");
  CHECK(message_of("Kd 1 0 0\nd 0.5\n") == "d 0.5 dropped, surfaces are opaque");
  CHECK(message_of("Kd 1 0 0\nd 1\nTr 0\nNi 1.0\nTf 1 1 1\n").empty());
  CHECK(message_of("Kd 1 0 0\nNi 1.45\nTf 1 0.5 1\nsharpness 60\n") ==
        "Ni dropped; Tf dropped; sharpness dropped");
  CHECK(message_of("Kd 1 0 0\nd 1 junk\n") == "d 1 junk dropped, surfaces are opaque");
  CHECK(message_of("Kd 1 0 0\nd -halo 0.5\n") == "d -halo 0.5 dropped, surfaces are opaque");
  CHECK(message_of("Kd 1 0 0\nd -halo 1\n").empty());
  CHECK(message_of("Ka 1 1 1\nKd spectral x.rfl 1\n") == "Kd spectral dropped, RGB is read");
  CHECK(message_of("Kd 1 0 0\nKd xyz 0.1 0.2 0.3\n") == "Kd xyz dropped, RGB is read");
  CHECK(material_of("Kd 1 0 0\nKd xyz 0.1 0.2 0.3\n").kd == rgb{1, 0, 0});
  CHECK(message_of("illum 1\n") == "no colour given, black");
  CHECK(material_of("illum 1\nKs 1 1 1\nNs 200\n").n == 200);
  CHECK(message_of("Kd 1 0 0 1 junk\n") == "'1 junk' behind Kd dropped");
  CHECK(message_of("illum 2\nKs 1 1 1\nNs 10 20\n") == "'20' behind Ns dropped");
  CHECK(message_of("Kd 1 0 0\nKd 0 1 0\n") == "Kd given again, the last one taken");
  CHECK(material_of("Kd 1 0 0\nKd 0 1 0\n").kd == rgb{0, 1, 0});
  CHECK(message_of("Kd 1 0 0 # red\n").empty());
  CHECK(message_of("Kd 1 0 0\nnewmtl a\nKd 0 1 0\n") == "defined again, the last one taken");
  for (const char* bad : {"Ns nan\n", "Ns\n", "Ns 1.2.3\n", "Ks nan 0 0\n", "Ks 0 0\n", "Kd inf\n",
                          "illum x\n", "Ns 0x10\n", "d foo\n", "Tr nan\n", "d\n"}) {
    const std::string refusal =
        refusal_of("mtllib m\nusemtl a\n" + kSquare + "f 1 2 3\n", {{"m", std::string("newmtl a\n") + bad}});
    CAPTURE(bad, refusal);
    CHECK(refusal.starts_with("m:2: "));
    CHECK(refusal.ends_with("expected a number"));
  }
}

TEST_CASE("a material's state does not leak into the next", "[scene]") {
  const auto made = read("mtllib m\n" + kSquare + "usemtl b\nf 1 2 3\nusemtl a\nf 1 3 4\n",
                         {{"m", "newmtl a\nillum 2\nKd 1 1 1\nKs 1 1 1\nNs 9\nnewmtl b\nillum 2\n"}});
  const material& b = made.of.materials[made.of.triangles[0].material];
  CHECK(b.name == "b");
  CHECK(b.kd == rgb{0, 0, 0});
  CHECK(b.ks == rgb{0, 0, 0});
  CHECK(made.of.materials[made.of.triangles[1].material].n == 9);
}

TEST_CASE("names with blanks, and libraries that are not there", "[scene]") {
  auto made = read("mtllib a library.mtl\n" + kSquare + "usemtl Hard Shiny  Plastic\nf 1 2 3\n",
                   {{"a library.mtl", "newmtl Hard Shiny  Plastic\nillum 1\nKd 1 0 0\n"}});
  CHECK(made.of.materials[made.of.triangles[0].material].kd == rgb{1, 0, 0});
  made = read("mtllib one.mtl two.mtl\n" + kSquare + "usemtl x\nf 1 2 3\n",
              {{"two.mtl", "newmtl x\nillum 1\nKd 0 1 0\n"}});
  CHECK(made.of.materials[made.of.triangles[0].material].kd == rgb{0, 1, 0});
  CHECK(made.messages[0] == "one.mtl: cannot be read, its materials are plain");
  made = read(kSquare + "usemtl nosuch\nf 1 2 3\n");
  CHECK(made.messages[0] == "material 'nosuch' is in no library, a plain one taken");
}

TEST_CASE("a number sign in a name is no comment", "[scene]") {
  const std::string library =
      "newmtl a#1\nillum 1\nKd 1 0 0\nnewmtl a#2\nillum 1\nKd 0 1 0\n"
      "newmtl Material #25 # as 3ds Max has it\nillum 1\nKd 0 0 1\n";
  const auto made = read("# mtllib none\nmtllib m # not m#\n" + kSquare +
                             "usemtl a#1\nf 1 2 3#x\nusemtl a#2 #\nf 1 3 4\n"
                             "usemtl Material #25\nf 2 3 4\n",
                         {{"m", library}});
  CAPTURE(made.messages);
  for (const std::string& each : made.messages) CHECK_FALSE(each.starts_with("material"));
  REQUIRE(made.of.triangles.size() == 3);
  const auto colour = [&](std::size_t triangle) {
    return made.of.materials[made.of.triangles[triangle].material].kd;
  };
  CHECK(colour(0) == rgb{1, 0, 0});
  CHECK(colour(1) == rgb{0, 1, 0});
  CHECK(colour(2) == rgb{0, 0, 1});
}

TEST_CASE("smoothing groups in any words", "[scene]") {
  for (const char* words : {"s off", "s OFF", "s on", "s On", "s 0", "s 2147483647"}) {
    CAPTURE(words);
    CHECK(refusal_of(std::string(words) + "\n" + kSquare + "f 1 2 3\n").empty());
  }
  CHECK(refusal_of("s 4294967295\n" + kSquare + "f 1 2 3\n") ==
        "a.obj:1: smoothing group is '4294967295', expected off or a number of at most 2147483647");
}

TEST_CASE("text of every encoding and line end is the same scene", "[scene]") {
  const std::string text = "mtllib m\n" + kSquare + "usemtl a\nf 1 2 3 4\n";
  const std::string mtl = "newmtl a\nillum 1\nKd 1 0 0\n";
  std::string crlf;
  for (const char each : text) crlf += each == '\n' ? "\r\n" : std::string(1, each);
  std::string cr = text;
  std::ranges::replace(cr, '\n', '\r');
  for (const std::string& each :
       {text, "\xEF\xBB\xBF" + text, as_utf16(text, false), as_utf16(text, true),
        as_utf16(text, true).substr(2), as_utf16(text, false).substr(2), crlf, cr}) {
    const auto made = read(each, {{"m", as_utf16(mtl, true)}});
    CHECK(made.of.triangles.size() == 2);
    CHECK(made.of.materials[made.of.triangles[0].material].kd == rgb{1, 0, 0});
  }
  CHECK(read(kSquare + "f 1 \\\n 2 3\\\n  4 # a comment\n").of.triangles.size() == 2);
  CHECK(read(kSquare + "f 1 2 3\\").of.triangles.size() == 1);
  CHECK(read("v +0 0. -.0e+2\nv 1e0 0 0\nv 1 1E0 0\nf -3 -2 -1").of.triangles.size() == 1);
}

TEST_CASE("the normals of a cube do not depend on how its squares are cut", "[scene]") {
  std::string text;
  for (int i = 0; i < 8; ++i)
    text += fmt::format("v {} {} {}\n", (i & 1) * 2 - 1, (i >> 1 & 1) * 2 - 1, (i >> 2) * 2 - 1);
  text += "s 1\nf 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";
  const auto made = read(text);
  REQUIRE(made.of.triangles.size() == 12);
  for (const triangle& each : made.of.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const vec& at = made.of.positions[each.position[k]];
      const vec& normal = made.of.normals[each.normal[k]];
      CHECK(normal.x == Approx(at.x / std::sqrt(3.0)));
      CHECK(normal.y == Approx(at.y / std::sqrt(3.0)));
      CHECK(normal.z == Approx(at.z / std::sqrt(3.0)));
    }
  }
}

TEST_CASE("a polygon of many corners is one face where it is smoothed", "[scene]") {
  // A prism whose caps have more corners than faces that are smoothed at one place.
  constexpr int kCorners = 1100;
  std::string text;
  std::string bottom("f");
  std::string top("f");
  std::string sides;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = 2 * golden::pi<double>() * i / kCorners;
    const int next = (i + 1) % kCorners;
    for (const int z : {-1, 1})
      text += fmt::format("v {:.17g} {:.17g} {}\n", std::cos(angle), std::sin(angle), z);
    top += fmt::format(" {}", 2 * i + 2);
    bottom += fmt::format(" {}", 2 * (kCorners - 1 - i) + 1);
    sides += fmt::format("f {} {} {} {}\n", 2 * i + 1, 2 * next + 1, 2 * next + 2, 2 * i + 2);
  }
  const auto made = read(text + "s 1\n" + bottom + "\n" + top + "\n" + sides);
  for (const std::string& each : made.messages) CHECK(each.find("not smoothed") == std::string::npos);
  // Corners of one height are alike.
  double least = 1;
  double most = -1;
  for (const triangle& each : made.of.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (made.of.positions[each.position[k]].z < 0) continue;
      least = std::min(least, made.of.normals[each.normal[k]].z);
      most = std::max(most, made.of.normals[each.normal[k]].z);
    }
  }
  CHECK(most - least < 1e-9);
}

TEST_CASE("indices are checked where they stand, and may lead ahead", "[scene]") {
  CHECK(read("f 1 2 3\n" + kSquare).of.triangles.size() == 1);
  CHECK(refusal_of("f 1 2 5\n" + kSquare) == "a.obj:1: vertex '5' does not exist, expected 1 to 4");
  CHECK(refusal_of(kSquare + "f 1 2 0\n") == "a.obj:5: vertex '0' does not exist, expected 1 to 4");
  CHECK(refusal_of(kSquare + "f 1 2 3.5\n") == "a.obj:5: vertex '3.5' does not exist, expected 1 to 4");
  CHECK(refusal_of(kSquare + "f 1 2 99999999999999999999\n") ==
        "a.obj:5: vertex '99999999999999999999' does not exist, expected 1 to 4");
  CHECK(refusal_of(kSquare + "f 1//9 2//9 3//9\n") == "a.obj:5: normal '9' does not exist, expected 1 to 0");
  CHECK(refusal_of(kSquare + "f 1/9 2/9 3/9\n") ==
        "a.obj:5: texture coordinate '9' does not exist, expected 1 to 0");
  CHECK(refusal_of(kSquare + "f 1/x 2/1 3/1\nvt 0 0\n") ==
        "a.obj:5: texture coordinate 'x' does not exist, expected 1 to 0");
  CHECK(refusal_of("vt nan 0\n" + kSquare) == "a.obj:1: texture coordinate has 'nan', expected a number");
  CHECK(refusal_of(kSquare + "f 1// 2// 3//\n") ==
        "a.obj:5: corner '1//' ends in a slash, expected an index behind it");
  CHECK(refusal_of(kSquare + "f 1/ 2/ 3/\n") ==
        "a.obj:5: corner '1/' ends in a slash, expected an index behind it");
  CHECK(read(kSquare + "f 1/1 2/1 3/1\nvt 0 0\n").of.triangles.size() == 1);
  CHECK(refusal_of("s x\n" + kSquare) == "a.obj:1: smoothing group is 'x', expected off or a number");
  CHECK(read("vt 0 0\nvn 0 0 1\n" + kSquare + "f 1/1/1 2/1/1 3/1/1\nf 1/1 3/1 4/1\nf 1//1 3//1 4//1\n")
            .of.triangles.size() == 3);
}

vec flat(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

/// A file of one face.
template <class Corner>
std::string polygon_of(int corners, const Corner& at) {
  std::string text;
  std::string face("f");
  for (int i = 0; i < corners; ++i) {
    const vec corner = at(i);
    text += fmt::format("v {:.17g} {:.17g} {:.17g}\n", corner.x, corner.y, corner.z);
    face += fmt::format(" {}", i + 1);
  }
  return text + face + "\n";
}

TEST_CASE("polygons are cut without loss or overlap", "[scene]") {
  // A disc of 200 corners, and a star that is not convex; areas by the shoelace formula.
  auto made = read(polygon_of(200, [](int i) { return flat(1, i * M_PI / 100); }));
  CHECK(made.of.triangles.size() == 198);
  CHECK(area_of(made.of) == Approx(100 * std::sin(M_PI / 100)));
  made = read(polygon_of(10, [](int i) {
    const vec at = flat(i % 2 == 0 ? 2 : 0.5, i * M_PI / 5);  // turned into the plane x + y + z = 0
    return vec{at.x / std::sqrt(2) + at.y / std::sqrt(6), -at.x / std::sqrt(2) + at.y / std::sqrt(6),
               -2 * at.y / std::sqrt(6)};
  }));
  CHECK(made.of.triangles.size() == 8);
  CHECK(area_of(made.of) == Approx(5 * 2 * 0.5 * std::sin(M_PI / 5)));
  CHECK(made.messages.size() == 2);  // of the material and the normals
  // One of too many corners is taken as convex, and said.
  made = read(polygon_of(2002, [](int i) { return flat(i % 2 == 0 ? 2 : 1, i * M_PI / 1001); }));
  CHECK(made.of.triangles.size() == 2000);
  constexpr const char* kAsConvex =
      "1 polygons that cut themselves, or of more than 2000 corners, taken as convex";
  CHECK(made.messages[1] == kAsConvex);
  // Bow ties: one whose halves cancel out, and one of a larger half.
  for (const char* ends : {"v 1 1 0\nv 0 1 0\n", "v 1 1 0\nv 0 3 0\n"}) {
    CAPTURE(ends);
    made = read(std::string("v 0 0 0\nv 1 0 0\n") + ends + "f 1 3 2 4\n");
    CHECK(std::ranges::count(made.messages, std::string(kAsConvex)) == 1);
  }
}

TEST_CASE("what is chosen for a file is said", "[scene]") {
  auto made = read("mtllib m\n" + kSquare + "f 1 2 3\nusemtl a\nf 1 3 4\n", {{"m", "newmtl a\nKd 1 0 0\n"}});
  CHECK(std::ranges::count(made.messages, "1 faces without usemtl, a plain material taken") == 1);
  made = read("vn 0 0 -1\n" + kSquare + "f 1//1 2//1 3//1\n");
  CHECK(std::ranges::count(made.messages, "1 triangles turned to face as their normals do") == 1);
  // A cone of so many sides that its tip is not smoothed.
  std::string cone = "v 0 0 1\n";
  for (int i = 0; i <= 1001; ++i)
    cone += fmt::format("v {} {} 0\n", std::cos(i * 2 * M_PI / 1001), std::sin(i * 2 * M_PI / 1001));
  for (int i = 0; i < 1001; ++i) cone += fmt::format("f 1 {} {}\n", i + 2, i + 3);
  made = read(cone);
  CHECK(std::ranges::count(made.messages, "1001 corners not smoothed, where more than 1000 faces meet") == 1);
}

TEST_CASE("libraries between quotes and behind tabs", "[scene]") {
  const std::map<std::string, std::string> files{
      {"my stuff.mtl", "newmtl a\nKd 1 0 0\n"}, {"b.mtl", "newmtl a\nKd 1 0 0\n"}, {"c.mtl", "newmtl c\n"}};
  for (const char* library : {"mtllib \"my stuff.mtl\"\n", "mtllib c.mtl\tb.mtl\n"}) {
    CAPTURE(library);
    const auto made = read(library + kSquare + "usemtl a\nf 1 2 3\n", files);
    CHECK(made.of.materials[made.of.triangles[0].material].kd == rgb{1, 0, 0});
  }
}

TEST_CASE("what has no area or no use is dropped and said", "[scene]") {
  auto made = read(kSquare + "f 1 2 3\nf 1 1 2\nf 1 2 1\nl 1 2\np 1\nl 2 3\ncurv x\n");
  CHECK(made.of.triangles.size() == 1);
  const auto says = [&](const char* text) {
    return std::ranges::find(made.messages, text) != made.messages.end();
  };
  CHECK(says("2 triangles without area dropped"));
  CHECK(says("2 lines 'l' dropped"));
  CHECK(says("1 lines 'p' dropped"));
  CHECK(says("1 lines 'curv' dropped"));
  made = read("v 0 0 0 1 0 0\nv 1 0 0 1 0 0\nv 1 1 0 1 0 0\nf 1 2 3\n");
  CHECK(says("3 numbers behind a vertex's three (weights, colours) dropped"));
  std::string kinds;
  for (int i = 0; i < 1000; ++i) kinds += fmt::format("kind{} x\n", i);
  made = read(kinds + kSquare + "f 1 2 3\n");
  CHECK(made.messages.size() == 23);  // twenty, the rest, material, normals
}

TEST_CASE("missing normals are computed by smoothing groups, or by a crease angle", "[scene]") {
  // Two faces at right angles along the x axis.
  const std::string roof = "v 0 0 0\nv 1 0 0\nv 0 -1 -1\nv 0 -1 1\n";
  const std::string faces = "f 1 2 3\nf 1 4 2\n";
  const auto normal_at_ridge = [&](const std::string& text) {
    const auto made = read(text);
    return std::pair{made.of.normals[made.of.triangles[0].normal[0]],
                     made.of.normals[made.of.triangles[1].normal[0]]};
  };
  const auto [smooth_a, smooth_b] = normal_at_ridge(roof + "s 1\n" + faces);
  CHECK(smooth_a.y == Approx(1));
  CHECK(smooth_b.y == Approx(1));
  const double half = std::sqrt(0.5);
  for (const char* group : {"s off\n", "s 0\n", ""}) {  // 90 degrees are a crease
    std::string text = roof;
    text.append(group).append(faces);
    const auto [flat_a, flat_b] = normal_at_ridge(text);
    CHECK(std::abs(flat_a.z) == Approx(half));
    CHECK(flat_a.z == Approx(-flat_b.z));
  }
  const auto [other_a, other_b] = normal_at_ridge(roof + "s 1\nf 1 2 3\ns 2\nf 1 4 2\n");
  CHECK(other_a.z == Approx(-other_b.z));
  // 30 degrees are none; places that are written twice are one.
  const std::string low =
      "v 0 0 0\nv 1 0 0\nv 0 -0.267949192431 -1\nv 0 -0.267949192431 1\nv 0 0 0\nv 1 0 0\n";
  const auto [low_a, low_b] = normal_at_ridge(low + "f 1 2 3\nf 5 4 6\n");
  CHECK(low_a.y == Approx(1));
  CHECK(low_b.y == Approx(1));
}

TEST_CASE("faces are wound as their own normals say, and normals of no length are computed", "[scene]") {
  const auto made = read("vn 0 0 -2\nvn 0 0 0\n" + kSquare + "f 1//1 2//1 3//1\nf 1//2 3//2 4//2\n");
  const auto normal_of = [&](const triangle& of) {
    const vec& a = made.of.positions[of.position[0]];
    return cross(made.of.positions[of.position[1]] - a, made.of.positions[of.position[2]] - a);
  };
  CHECK(normal_of(made.of.triangles[0]).z == -1);
  CHECK(made.of.normals[made.of.triangles[0].normal[0]].z == -1);
  CHECK(normal_of(made.of.triangles[1]).z == 1);
  CHECK(made.of.normals[made.of.triangles[1].normal[0]].z == 1);
  CHECK(std::ranges::count(made.messages, "3 normals of length 0 dropped") == 1);
}

}  // namespace
