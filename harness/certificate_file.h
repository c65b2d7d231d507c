// Certificates as JSON files.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "algorithms/api/certificate.h"

namespace mda {

struct CertificateFile {
  std::string fingerprint;   ///< of the window
  std::vector<int> columns;  ///< the choice
  Certificate certificate;
};

/// {"schema": 1, "fingerprint": "...", "bits": 24, "cost": -70, "columns": [0], "steps": [...]}; a
/// step is an object of one key: "prices" (an object of the lists "rows", "values", "cuts",
/// "cut_values"), "odd_rows", "clique", "row_pair" (lists), "column" (a number), "parts" (a list of
/// objects of "rows" and "floor") or "enumerate" (true).
[[nodiscard]] std::string certificate_json(const CertificateFile& file);

/// Reads it back. Throws InputError that begins with `file` and names the place.
[[nodiscard]] CertificateFile parse_certificate(std::string_view text, const std::string& file);

}  // namespace mda
