"""python -m wakesurf.mcp"""
import sys

from wakesurf.mcp import main

if __name__ == "__main__":
    sys.exit(main())
