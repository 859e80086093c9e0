// How long this program has been running.
#pragma once

namespace rt {

/// Seconds since the system started the process, loading included; at most 1/100 s too many. Linux's /proc; where it cannot be read, since
/// the first call.
double process_age();

}  // namespace rt
