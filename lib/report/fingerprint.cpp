#include "lib/report/fingerprint.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

namespace loadpath::report {

std::string fingerprint(std::string_view input, const project::Project& project) {
  std::string all(input);
  for (const project::NamedFile& file : project.files) all += file.text;
  const boost::uuids::name_generator_sha1 generator(boost::uuids::ns::oid());
  return boost::uuids::to_string(generator(all.data(), all.size()));
}

}  // namespace loadpath::report
