// SPDX-License-Identifier: MIT
// The server on two file descriptors.
#pragma once

namespace cobble::lsp {

/// Serves until the client says `exit`, closes `input`, or reads no more of `output`. All that has
/// arrived is read before any work that nobody waits for is begun or gone on with. Gives the
/// process's exit status: 0 after `shutdown` and `exit`, else 1.
int serve(int input, int output);

}  // namespace cobble::lsp
