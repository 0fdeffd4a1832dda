#!/usr/bin/python3
"""flood.py PTY: a pseudo-terminal at PTY that sends a megabyte of rubbish a second, as fast as it is read, and
listens to nobody."""
import os
import random
import sys
import threading
import time
import tty

BYTES_S = 1_000_000


def swallow(robot):
    while os.read(robot, 65_536):
        pass


def main():
    robot, page = os.openpty()
    tty.setraw(page)
    os.symlink(os.ttyname(page), sys.argv[1])
    threading.Thread(target=swallow, args=(robot,), daemon=True).start()
    rubbish = random.Random(1).randbytes(1 << 20)
    begin, sent = time.monotonic(), 0
    while True:
        at = sent % len(rubbish)
        sent += os.write(robot, rubbish[at : at + 4096])
        ahead = sent / BYTES_S - (time.monotonic() - begin)
        if ahead > 0:
            time.sleep(ahead)
        elif ahead < -0.1:
            # Nobody has read for a while: what was missed is not caught up.
            begin, sent = time.monotonic(), 0


main()
