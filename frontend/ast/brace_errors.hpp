// SPDX-License-Identifier: MIT
// Findings about braces, and about what stands outside every field.
#pragma once

#include <string_view>

#include "frontend/ast/reporter.hpp"
#include "frontend/parse/cst.hpp"

namespace cobble::frontend {

/// A block without its {, or }, or both: one finding at the place where the first of them is
/// missing.
void report_missing_braces(const Cst& cst, NodeId block, Reporter& reporter);

/// A } that closes nothing, or stands in the middle of the block `where`.
void report_extra_brace(const CstNode& node, std::string_view where, Reporter& reporter);

/// { ... } without a name.
void report_nameless(const CstNode& node, Reporter& reporter);

/// Values where no field can take them; `where` is the open block's name, or empty for the file.
void report_stray_values(const CstNode& node, std::string_view where, Reporter& reporter);

}  // namespace cobble::frontend
