"""From protocol/api/*.schema.json to everything that says what the API is: see protocol/api/README.md."""
