#!/usr/bin/python3
"""mute.py PTY [HIS]: a pseudo-terminal at PTY whose robot says nothing at all; or nothing until it has heard so
many `hi`: from then on it says who it is, and refuses everything else."""
import os
import sys
import tty


def crc8(data):
    crc = 0
    for byte in data:
        crc ^= byte
        for _ in range(8):
            crc = (crc << 1 ^ 0x07 if crc & 0x80 else crc << 1) & 0xFF
    return crc


def lines(robot):
    rest = b""
    while True:
        *whole, rest = (rest + os.read(robot, 4096)).split(b"\n")
        yield from (line for line in whole if line)


def main():
    robot, page = os.openpty()
    tty.setraw(page)
    # The link comes last: whoever waits for it finds all the rest.
    os.symlink(os.ttyname(page), sys.argv[1])
    wanted = int(sys.argv[2]) if len(sys.argv) > 2 else None

    def say(line):
        os.write(robot, b"%s*%02X\n" % (line, crc8(line)))

    his = 0
    for line in lines(robot):
        tag = line.partition(b"*")[0].split()[-1]
        is_hi = line.startswith(b"hi")
        his += is_hi
        if wanted is None or his < wanted:
            continue
        if is_hi:
            say(b"ready 1 late-1 uno 30 400")
            say(b"ok " + tag)
        else:
            say(b"err " + tag + b" verb not known")


main()
