# SPDX-License-Identifier: Apache-2.0
# A model of one's own, judged through a pipe: the quadratic device at q8, in whole numbers.
#
#   blysk vectors --format q8 | python3 vectors_model.py | blysk check --format q8
import sys

for line in sys.stdin:
    if line.startswith("#"):
        print(line, end="")
        continue
    n, cos, r, g, b = (int(word, 16) for word in line.split())
    a = 201 * n - 128  # 8 fraction bits: 201/256 is the slope, 1/2 the offset
    parabola = a * (cos * cos - 256 * cos) + (cos << 16)  # 24 fraction bits
    brdf = min(max((parabola + (1 << 15)) >> 16, 0), 256)
    print(line.strip(), *(f"{brdf * colour:04x}" for colour in (r, g, b)))
