// A folder of files that appears all at once or not at all.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "samples/io/place.hpp"
#include "samples/show/canvas.hpp"

namespace relevo::show {

// The folder while it is being filled. Names of files are relative; "/" leads into folders below.
class Workplace {
  public:
    io::Failure write(const std::string& file, std::string_view bytes);
    io::Failure write(const std::string& file, const Picture& picture);  // as PNG

  private:
    friend io::Failure fill_folder(const std::string&, const std::function<io::Failure(Workplace&)>&);
    io::Failure open(const std::string& directory);
    io::Failure publish() const;
    void abandon() const;
    // Where the file is written for now, or why it cannot be.
    io::FileResult<std::string> draft_path(const std::string& file);

    std::filesystem::path target_, draft_;
    std::filesystem::path made_;  // the topmost folder that did not exist before; empty when all did
    std::vector<std::string> files_;
};

// Makes the folder when it is missing and lets `fill` write. When that fails, the failure is returned, what
// was there before is unchanged, and a folder that was made is removed. Other files in the folder stay.
io::Failure fill_folder(const std::string& directory, const std::function<io::Failure(Workplace&)>& fill);

}  // namespace relevo::show
