# SPDX-License-Identifier: Apache-2.0
# Host of a device behind its serial wrapper: a line goes out when the answer to the one before is complete.
#
#   blysk vectors --format q8 | python3 serial_host.py /dev/ttyUSB1 | blysk check --format q8
import os
import sys
import termios
import tty

if len(sys.argv) != 2:
    sys.exit("usage: serial_host.py DEVICE, such as /dev/ttyUSB1")
try:
    line = os.open(sys.argv[1], os.O_RDWR | os.O_NOCTTY)
    tty.setraw(line)
except (OSError, termios.error) as error:
    sys.exit(f"{sys.argv[1]}: {error.args[1]}, expected a serial line")
settings = termios.tcgetattr(line)
settings[4] = settings[5] = termios.B115200
termios.tcsetattr(line, termios.TCSAFLUSH, settings)
for vector in sys.stdin.buffer:
    os.write(line, vector)
    answer = b""
    while not answer.endswith(b"\n"):
        answer += os.read(line, 256)
    sys.stdout.buffer.write(answer)
