#!/usr/bin/env bash
# SPDX-License-Identifier: Apache-2.0
# html_test.sh BLYSK: the page of `explore --html` in a real browser, without a network: every row is drawn, pointing at a point
# shows its row, a click gives its command, and another error moves the points. Exit 77 where Chromium is missing.
set -euo pipefail
unset CDPATH
browser=$(command -v chromium || command -v chromium-browser) || exit 77
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$1" explore --html "$work/page.html"
# What a reader does, and what he sees, as text behind the page.
cat >"$work/reader.html" <<'PAGE'
<pre id="seen"></pre>
<script>
window.onerror = message => { document.getElementById("seen").textContent += "error " + message + "\n"; };
const see = (what, value) => { document.getElementById("seen").textContent += what + " " + value + "\n"; };
const circles = () => [...document.querySelectorAll("circle")];
const shown = rows.filter(row => row.domain === "sphere" && row.lut && row.max_abs_err);
see("rows", shown.length === circles().length && shown.length > 0);
circles()[0].dispatchEvent(new MouseEvent("mouseenter"));
see("tip", getComputedStyle(document.getElementById("tip")).display + " " + document.getElementById("tip").textContent.split("\n")[1].trim());
circles()[0].dispatchEvent(new MouseEvent("mouseleave"));
see("gone", getComputedStyle(document.getElementById("tip")).display);
const before = circles().map(circle => circle.getAttribute("cy")).join();
document.getElementById("error").value = "mean_abs_err";
document.getElementById("error").dispatchEvent(new Event("change"));
see("moved", before !== circles().map(circle => circle.getAttribute("cy")).join());
see("places", circles().every(circle => Number(circle.getAttribute("cx")) >= 80 && Number(circle.getAttribute("cx")) <= 930 &&
                              Number(circle.getAttribute("cy")) >= 20 && Number(circle.getAttribute("cy")) <= 485));
circles()[0].dispatchEvent(new MouseEvent("click"));
document.querySelector("tbody tr").dispatchEvent(new MouseEvent("click", {bubbles: true}));
setTimeout(() => see("said", document.getElementById("said").textContent), 300);
</script>
PAGE
cat "$work/page.html" "$work/reader.html" >"$work/both.html"
"$browser" --headless --no-sandbox --disable-gpu --user-data-dir="$work/profile" --virtual-time-budget=2000 \
  --dump-dom "file://$work/both.html" >"$work/dom" 2>"$work/log" || { cat "$work/log"; exit 1; }
sed -n '/<pre id="seen">/,/<\/pre>/p' "$work/dom" | sed 's/<pre id="seen">//' >"$work/seen"
cat "$work/seen"
if grep -q '^error' "$work/seen"; then exit 1; fi
grep -qx 'rows true' "$work/seen"
grep -q '^tip block sphere, exhaustive, [0-9]* points' "$work/seen"
grep -qx 'gone none' "$work/seen"
grep -qx 'moved true' "$work/seen"
grep -qx 'places true' "$work/seen"
grep -q '^said copied: scripts/synth ' "$work/seen"
