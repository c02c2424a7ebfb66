#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# check_includes_test.sh ROOT: in a copy of the tree, scripts/check-includes reports each of the lines below once it stands
# in its file, and does not report what is allowed.
set -euo pipefail
unset CDPATH
cd "$1"
device=$(sed -nE 's/^BLYSK_DEVICE\(([a-z0-9_]+),.*/\1/p' tb/devices/devices.def | sed -n 1p)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir "$work/scripts"
cp -r rtl_sysc tb "$work"
cp scripts/check-includes scripts/lib.sh "$work/scripts"
cd "$work"
status=0

# reported FILE LINE, ignored FILE LINE: what the check says of the line at the end of the file.
says() {
  local size found
  size=$(stat -c %s "$1")
  printf '%s\n' "$2" >>"$1"
  found=$(scripts/check-includes | grep -cF "$1:$(wc -l <"$1"):" || true)
  truncate -s "$size" "$1"
  [ "$found" -gt 0 ]
}
reported() { says "$@" || { printf '%s: not reported: %s\n' "$1" "$2"; status=1; }; }
ignored() { ! says "$@" || { printf '%s: reported: %s\n' "$1" "$2"; status=1; }; }

reported rtl_sysc/blocks/mul.h '#include "tb/port.h"'
reported rtl_sysc/blocks/mul.h '#include <vector>'
reported rtl_sysc/blocks/mul.h '  double x = 0;'
reported rtl_sysc/blocks/mul.h '  sc_dt::sc_fixed<8, 4> x;'
reported rtl_sysc/blocks/mul.h '  return clamp(a, T{Y::min}, T{Y::max});'
reported rtl_sysc/blocks/mul.h '  return std::int64_t{table[i]};'
reported rtl_sysc/blocks/mul.h '  return T{1} << k;'
reported rtl_sysc/blocks/mul.h '    sensitive << clk.pos();'
reported rtl_sysc/blocks/mul.h '    SC_CTHREAD(load, clk);'
reported rtl_sysc/blocks/mul.h '  return std::min(a, b);'
reported rtl_sysc/blocks/mul.h '    const auto sum = [&](int a) { return a + 1; };'
ignored rtl_sysc/blocks/mul.h '  return T(Y::max);  // not T{Y::max}'
ignored rtl_sysc/blocks/mul.h '  return table[i](2) + std::int64_t{1};'
ignored rtl_sysc/blocks/clocked.h '    sensitive << clk.pos();'
reported tb/golden/angle.h '#include "rtl_sysc/qformat.h"'
reported tb/golden/angle.h '#include "tb/device.h"'
reported tb/claims/claim.h '#include "tb/device.h"'
reported tb/blocks/law_test.cpp '#include "tb/netlist/block.h"'
reported tb/netlist/block.h '#include "tb/devices/test/asked.h"'
reported tb/specular/specular.h '#include "tb/harness/systemc_engine.h"'
reported tb/harness/systemc_engine.h '#include "tb/export/export.h"'
reported tb/export/export.h '#include "tb/cli/stream.h"'
reported tb/export/export.h '#include "tb/cost/digest.h"'
reported tb/cost/digest.h '#include "tb/harness/systemc_engine.h"'
ignored tb/cost/digest.h '#include "tb/export/export.h"'
reported tb/certificate/certify.cpp '#include "tb/harness/systemc_engine.h"'
ignored tb/certificate/certify.cpp '#include "tb/netlist/elaborated.h"'
reported tb/devices/registry.cpp '#include "tb/harness/systemc_engine.h"'
ignored tb/devices/test/equality_test.cpp '#include "tb/harness/systemc_engine.h"'
reported tb/scene/scene.h '#include "tb/device.h"'
reported tb/scene/scene.h '#include "tb/render/picture.h"'
reported tb/render/render.h '#include "tb/cosim/replay.h"'
reported tb/render/render.h '#include "tb/specular/specular.h"'
reported tb/render/render.h '#include "tb/harness/systemc_engine.h"'
reported tb/render/render.h '#include "rtl_sysc/blocks/law.h"'
reported tb/render/effects/ambient.h '#include "tb/scene/scene.h"'
reported tb/render/effects/ambient.h '#include "rtl_sysc/qformat.h"'
reported tb/render/effects/ambient.h '#include "rtl_sysc/blocks/mul.h"'
ignored tb/render/effects/ambient.h '#include "rtl_sysc/blocks/law.h"'
ignored tb/render/render.h '#include "tb/scene/scene.h"'
reported tb/devices/registry.cpp '#include "tb/scene/scene.h"'
reported tb/cosim/strobes.h '#include "tb/cli/stream.h"'
reported tb/inputs.cpp "  return choose(\"$device\", \"q8\");"
reported tb/netlist/CMakeLists.txt "blysk_add_test(unit.${device}_x SOURCES a.cpp)"
reported tb/harness/systemc_engine.cpp "#include \"tb/devices/$device/wires.h\""
reported tb/inputs.cpp '  SC_HAS''_PROCESS(x);'
reported tb/inputs.cpp '  use([&, size'' = size] { return size; });'
reported tb/inputs.cpp 'int main(int argc, char** argv) { return run(argc, argv); }'
ignored tb/inputs.cpp "  // such as $device"
word=pow''er # of mathematics, and a device
reported tb/inputs.cpp "  return choose(\"$word\", \"q8\");"
reported tb/inputs.cpp "#include \"tb/devices/$word/kernel.h\""
ignored tb/inputs.cpp "  const double $word = ${word}_of(x);"
ignored "tb/devices/$device/wires.h" "namespace blysk::${device}_device {}"
ignored tb/inputs.cpp "  return golden::$device(1, 2);"
exit $status
