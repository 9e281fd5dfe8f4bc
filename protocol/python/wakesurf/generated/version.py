"""The version, as in CMakeLists.txt.

Made by protocol/api/generate from protocol/api/*.schema.json: do not edit.
"""
VERSION = "0.1.0"
