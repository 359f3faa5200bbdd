#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <iterator>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <rmap/scan.hpp>
#include <rmap/scan_read_options.hpp>

namespace rmap {

/// What a source met in a pass beside the scans that it gave.
struct ScanNotes {
  std::uint64_t without_pose = 0;  ///< scans passed over because no pose is known for them
  /// What is wrong with the files and could be read all the same, a sentence each.
  std::vector<std::string> warnings = {};
  /// What is sound and yet worth knowing, a sentence each.
  std::vector<std::string> remarks = {};

  ScanNotes& operator+=(const ScanNotes& other);
};

/// Scans with poses, one after another: what every format of scans is read
/// through. Holds one scan at a time, so the scans may be larger than memory.
class ScanSource {
 public:
  ScanSource() = default;
  ScanSource(const ScanSource&) = delete;
  ScanSource& operator=(const ScanSource&) = delete;
  virtual ~ScanSource() = default;

  /// Reads the next scan into `scan`, whose buffers it reuses and whose fields it
  /// all sets; false at the end, and `scan` is then unspecified. Throws Error(input)
  /// when the content is not what the format allows, Error(limit) when it is too
  /// large, Error(io) when it cannot be read. The call after an error goes on with
  /// the scan behind it, so that one pass can find all that is wrong.
  virtual bool next(Scan& scan) = 0;

  /// Goes back to the first scan.
  virtual void rewind() = 0;

  /// Number of scans of a whole pass, where it is known without reading them.
  virtual std::optional<std::size_t> size() const = 0;

  /// Of this pass. To be asked when `next` has said that it is over: before, it may lack
  /// what is still to come or read ahead of the caller.
  virtual ScanNotes notes() const { return {}; }
};

/// Opens scans by what `path` is:
///
/// - a folder of scans: all its files of one format in natural order (2 before 10): `.bin`
///   (KITTI: little-endian float32 x, y, z, intensity; at least one point), `.pcd`, `.ply`,
///   `.las`, 3DTK's `.3d`, or text (`.xyz`, `.csv`) where none of these is there; and beside
///   them `poses.txt` with one pose a scan, as in `read_poses`, 3DTK's `.pose` files, KITTI's
///   layout, or the trajectory of the options (docs/formats/scan-folders.md). Points are in the
///   sensor's frame, in metres. Other files, subfolders and names that begin with a dot are
///   passed over; a folder with two formats is an error.
/// - one scan file of such a folder: that scan alone, with its pose. A lone file's is in the
///   file (VIEWPOINT of a `.pcd`, an origin for each point) or in the options.
/// - a scan graph of OctoMap (`.graph`).
/// - a bag of ROS 2: an MCAP file (`.mcap`), a `.db3` of rosbag2, or the folder with
///   `metadata.yaml` that rosbag2 makes. Clouds (sensor_msgs/PointCloud2) are scans, in the
///   order of their recording; `ScanReadOptions` say of which topic and where poses come from.
///
/// The listing, the poses and their number are checked here, the scans when they
/// are read: a pass with `next` to the end checks everything. Throws Error as `next`.
std::unique_ptr<ScanSource> open_scans(const std::filesystem::path& path,
                                       const ScanReadOptions& options = {});

/// Opens several paths as one source, in the order given; at least one.
std::unique_ptr<ScanSource> open_scan_sequence(const std::vector<std::filesystem::path>& paths,
                                               const ScanReadOptions& options = {});

/// Reads the scans of `source`, which is not null, in a thread of its own, up to two ahead
/// of the one that was asked for: reading and decoding run beside what the caller does
/// with the scans. The same scans, and the same errors at the same calls.
std::unique_ptr<ScanSource> read_ahead(std::unique_ptr<ScanSource> source);

/// Scans as a range for one pass; `rewind()` allows another. A reference to a scan
/// lives until the next `++`, which may throw Error as `ScanSource::next`.
///
///     for (const rmap::Scan& scan : rmap::read_scans("street/")) grid.insert(scan);
///
/// Moving the range invalidates its iterators.
class ScanRange {
 public:
  class Iterator {
   public:
    using iterator_concept = std::input_iterator_tag;
    using difference_type = std::ptrdiff_t;
    using value_type = Scan;

    const Scan& operator*() const { return range_->scan_; }
    const Scan* operator->() const { return &range_->scan_; }
    Iterator& operator++() {
      range_->advance();
      return *this;
    }
    void operator++(int) { range_->advance(); }
    friend bool operator==(const Iterator& iterator, std::default_sentinel_t) {
      return iterator.at_end();
    }

   private:
    friend class ScanRange;
    explicit Iterator(ScanRange* range) : range_(range) {}
    bool at_end() const { return range_->at_end_; }

    ScanRange* range_;
  };

  /// `source` is not null and stands at its first scan.
  explicit ScanRange(std::unique_ptr<ScanSource> source) : source_(std::move(source)) {}

  /// Reads the first scan. Throws Error as `ScanSource::next`, and Error(usage) when
  /// the pass has begun already: a second loop needs `rewind()` first.
  Iterator begin();
  std::default_sentinel_t end() const { return std::default_sentinel; }

  /// Goes back to the first scan; iterators of the former pass are invalid.
  void rewind();
  /// Number of scans of a whole pass, where it is known without reading them.
  std::optional<std::size_t> size() const { return source_->size(); }

 private:
  void advance();

  std::unique_ptr<ScanSource> source_;
  Scan scan_;
  bool begun_ = false;
  bool at_end_ = false;
};

/// The scans of `open_scans(path)` as a range.
ScanRange read_scans(const std::filesystem::path& path, const ScanReadOptions& options = {});

/// The scans of `open_scan_sequence(paths)` as a range.
ScanRange read_scan_sequence(const std::vector<std::filesystem::path>& paths,
                             const ScanReadOptions& options = {});

}  // namespace rmap
