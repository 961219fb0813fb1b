#pragma once
// The text of Home.xml out of a .sh3d archive.

#include <cstddef>
#include <span>
#include <string>

namespace enfilade::plans {

/// The bytes of the entry Home.xml. Throws InputError: P150 no readable archive, P151 only the Java-serialised home,
/// P152 no home at all, P153 an entry that is encrypted, damaged or larger than 64 MiB.
[[nodiscard]] std::string home_xml(std::span<const std::byte> archive, const std::string& file_name);

}  // namespace enfilade::plans
