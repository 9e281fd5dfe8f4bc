"""Made by protocol/api/generate from protocol/api/*.schema.json: do not edit."""
