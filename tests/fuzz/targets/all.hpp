// Every target and its seeds; each has a file of its name here.
#pragma once

#include "tests/fuzz/target.hpp"

namespace wakesurf::fuzz {

void mesh_decoder(Input input);
void json_rpc(Input input);
void settings(Input input);
void records(Input input);
void journal_rows(Input input);
void store_manifest(Input input);
void command_line_text(Input input);
void gate(Input input);
void ensight(Input input);
void plot3d(Input input);
void netcdf(Input input);

std::vector<std::string> mesh_decoder_seeds();
std::vector<std::string> json_rpc_seeds();
std::vector<std::string> settings_seeds();
std::vector<std::string> records_seeds();
std::vector<std::string> journal_rows_seeds();
std::vector<std::string> store_manifest_seeds();
std::vector<std::string> command_line_text_seeds();
std::vector<std::string> gate_seeds();
std::vector<std::string> ensight_seeds();
std::vector<std::string> plot3d_seeds();
std::vector<std::string> netcdf_seeds();

} // namespace wakesurf::fuzz
