#!/usr/bin/python3
"""mute.py PTY [SECONDS]: a pseudo-terminal at PTY whose robot says nothing at all, or only `ready`, so many
seconds after it was first spoken to."""
import os
import sys
import time
import tty


def crc8(data):
    crc = 0
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc << 1 ^ 0x07 if crc & 0x80 else crc << 1) & 0xFF
    return crc


def main():
    robot, page = os.openpty()
    tty.setraw(page)
    os.symlink(os.ttyname(page), sys.argv[1])
    os.read(robot, 1)
    if len(sys.argv) > 2:
        time.sleep(float(sys.argv[2]))
        line = b"ready 1 late-1 uno 30 400"
        os.write(robot, b"%s*%02X\n" % (line, crc8(line)))
    while os.read(robot, 4096):
        pass


main()
