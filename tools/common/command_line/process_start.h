// SPDX-License-Identifier: Apache-2.0
//
// What the programs of the command line tool do before all else.

#pragma once

namespace wellstrat::cli {

/// Opens the standard streams that are closed, so that no file gets their numbers and with it what
/// is meant for them: to read or write them fails. Writing beyond the limit on the size of files
/// fails too, instead of ending the program. What would end the program by std::terminate, such as
/// a lack of memory where no exception may leave, ends it with one line, kExitError, and without
/// temporary files; so does std::abort, with the line of who calls it.
void startProcess();

/// Ends the program with this exit code, and leaves out the destructors of static objects: of those
/// in other libraries, some end it by a crash after a lack of memory that was mended. All output of
/// ours is written by then.
[[noreturn]] void endProcess(int exitCode);

} // namespace wellstrat::cli
