#pragma once

namespace chiaro {

/// Sets some memory aside for the moment when there is none. The first `new` that is refused afterwards gets
/// it, so that what runs then can end in order: libraries allocate even while they clean up, and would end
/// the program where they can't. A `new` that is refused after that throws std::bad_alloc as ever. Called at
/// a program's start, and again once work has failed for want of memory; does nothing while the reserve is
/// untouched or can't be had. Any thread.
void keepMemoryReserve();

}  // namespace chiaro
