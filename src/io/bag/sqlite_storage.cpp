#include "io/bag/sqlite_storage.hpp"

#include "io/bag/unpack.hpp"
#include "io/text.hpp"

#include <algorithm>
#include <limits>
#include <new>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <sqlite3.h>

#include <rmap/error.hpp>

namespace rmap {

namespace {

// A row of messages takes more bytes of the file than this.
constexpr std::uint64_t kLeastRow = 4;

// A file's name as SQLite takes it among other things: what has a meaning there is escaped.
std::string uri_of(const std::filesystem::path& file) {
  std::string uri = "file:";
  const std::string path = std::filesystem::absolute(file).string();
  for (const char character : path) {
    const bool plain = (character >= 'a' && character <= 'z') ||
                       (character >= 'A' && character <= 'Z') ||
                       (character >= '0' && character <= '9') || character == '/' ||
                       character == '.' || character == '_' || character == '-';
    if (plain) {
      uri += character;
    } else {
      uri += fmt::format("%{:02X}", static_cast<unsigned char>(character));
    }
  }
  return uri + "?mode=ro&immutable=1";
}

std::string text_at(sqlite3_stmt* row, int column) {
  const unsigned char* text = sqlite3_column_text(row, column);
  const int size = sqlite3_column_bytes(row, column);
  return text == nullptr
             ? std::string()
             : std::string(reinterpret_cast<const char*>(text), static_cast<std::size_t>(size));
}

std::span<const std::byte> bytes_at(sqlite3_stmt* row, int column) {
  const void* bytes = sqlite3_column_blob(row, column);
  const int size = sqlite3_column_bytes(row, column);
  return {static_cast<const std::byte*>(bytes), bytes == nullptr ? 0 : static_cast<size_t>(size)};
}

// Rows come in the order of their ids; a page that hangs in a hostile tree twice does not.
class Increasing {
 public:
  bool accept(std::int64_t id) {
    const bool increases = !last_ || id > *last_;
    last_ = id;
    return increases;
  }

 private:
  std::optional<std::int64_t> last_;
};

}  // namespace

void SqliteStorage::Close::operator()(sqlite3* database) const { sqlite3_close_v2(database); }

void SqliteStorage::Finalize::operator()(sqlite3_stmt* statement) const {
  sqlite3_finalize(statement);
}

Error SqliteStorage::damaged(std::string_view problem) const {
  return {ErrorKind::input, fmt::format("{} is damaged: {}", file_.string(), problem)};
}

// SQLite says so of some damaged schemas too, however much memory there is.
Error SqliteStorage::short_of_memory() const {
  return {ErrorKind::input, fmt::format("{} cannot be read: it is damaged, or there is not enough "
                                        "memory (SQLite says: out of memory)",
                                        file_.string())};
}

SqliteStorage::SqliteStorage(std::filesystem::path file)
    : file_(std::move(file)), file_size_(std::filesystem::file_size(file_)) {
  open();
  harden();
  check_size();
  require_table("topics");
  require_table("messages");
  read_topics();
  const std::filesystem::path journal = file_.string() + "-wal";
  std::error_code missing;
  const auto size = std::filesystem::file_size(journal, missing);
  if (!missing && size > 0) {
    warnings_.push_back(
        fmt::format("{} was not closed by its recorder: the messages in {} ({} "
                    "bytes) are not read; sqlite3 {} 'PRAGMA wal_checkpoint' "
                    "brings them in",
                    file_.string(), journal.string(), size, file_.string()));
  }
}

void SqliteStorage::open() {
  sqlite3* database = nullptr;
  const int code = sqlite3_open_v2(
      uri_of(file_).c_str(), &database,
      SQLITE_OPEN_READONLY | SQLITE_OPEN_URI | SQLITE_OPEN_NOMUTEX | SQLITE_OPEN_PRIVATECACHE,
      nullptr);
  database_.reset(database);
  if (code == SQLITE_NOMEM) throw std::bad_alloc();
  if (code != SQLITE_OK) {
    throw Error(ErrorKind::io,
                fmt::format("cannot open {}: {}", file_.string(), sqlite3_errstr(code)));
  }
}

void SqliteStorage::harden() {
  sqlite3* database = database_.get();
  sqlite3_db_config(database, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(database, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  // Nothing stored is longer than the file; what is made up by a generated column could be.
  constexpr std::uint64_t kLeastLength = 1000;
  sqlite3_limit(
      database, SQLITE_LIMIT_LENGTH,
      static_cast<int>(std::clamp<std::uint64_t>(file_size_, kLeastLength, kMostUnpacked)));
  sqlite3_limit(database, SQLITE_LIMIT_SQL_LENGTH, 1'000'000);
  sqlite3_limit(database, SQLITE_LIMIT_COLUMN, 100);
  sqlite3_limit(database, SQLITE_LIMIT_EXPR_DEPTH, 20);
  sqlite3_limit(database, SQLITE_LIMIT_VDBE_OP, 25'000);
  sqlite3_limit(database, SQLITE_LIMIT_ATTACHED, 0);
  for (const char* pragma :
       {"PRAGMA query_only=ON", "PRAGMA cell_size_check=ON", "PRAGMA mmap_size=0"}) {
    const Statement statement = prepare(pragma);
    while (step(statement.get())) {
    }
  }
}

SqliteStorage::Statement SqliteStorage::prepare(std::string_view sql) const {
  sqlite3_stmt* statement = nullptr;
  const int code = sqlite3_prepare_v2(database_.get(), sql.data(), static_cast<int>(sql.size()),
                                      &statement, nullptr);
  if (code == SQLITE_NOMEM) throw short_of_memory();
  if (code != SQLITE_OK) {
    throw damaged(fmt::format("SQLite says: {}", sqlite3_errmsg(database_.get())));
  }
  return Statement(statement);
}

bool SqliteStorage::step(sqlite3_stmt* statement) const {
  const int code = sqlite3_step(statement);
  if (code == SQLITE_ROW) return true;
  if (code == SQLITE_DONE) return false;
  if (code == SQLITE_NOMEM) throw short_of_memory();
  const std::string reason = sqlite3_errmsg(database_.get());
  if ((code & 0xFF) == SQLITE_IOERR) {
    throw Error(ErrorKind::io, fmt::format("cannot read {}: {}", file_.string(), reason));
  }
  throw damaged(fmt::format("SQLite says: {}", reason));
}

// SQLite itself reads a file whose last page is cut off as if zeros followed.
void SqliteStorage::check_size() const {
  const auto number = [&](const char* pragma) {
    const Statement statement = prepare(pragma);
    return step(statement.get())
               ? static_cast<std::uint64_t>(sqlite3_column_int64(statement.get(), 0))
               : 0;
  };
  const std::uint64_t pages = number("PRAGMA page_count");
  const std::uint64_t page_size = number("PRAGMA page_size");
  if (pages * page_size <= file_size_) return;
  throw Error(ErrorKind::input,
              fmt::format("{} is cut off: it has {} bytes, and its {} pages of {} "
                          "bytes take {}",
                          file_.string(), file_size_, pages, page_size, pages * page_size));
}

void SqliteStorage::require_table(const char* name) const {
  const Statement found = prepare("SELECT type, sql FROM sqlite_schema WHERE name = ?1");
  sqlite3_bind_text(found.get(), 1, name, -1, SQLITE_STATIC);
  const bool is_table = step(found.get()) && text_at(found.get(), 0) == "table" &&
                        !text_at(found.get(), 1).starts_with("CREATE VIRTUAL");
  if (is_table) return;
  throw Error(ErrorKind::input,
              fmt::format("{} is no bag: a .db3 of rosbag2 has tables topics and messages, and {} "
                          "is missing in this database",
                          file_.string(), name));
}

void SqliteStorage::read_topics() {
  const Statement rows = prepare(
      "SELECT id, name, type, serialization_format FROM topics "
      "NOT INDEXED");
  Increasing ids;
  while (step(rows.get())) {
    const std::int64_t id = sqlite3_column_int64(rows.get(), 0);
    if (!ids.accept(id)) throw damaged(fmt::format("topic {} comes twice or out of order", id));
    check_topic_count(file_, topics_.size());
    topics_.emplace(id, BagTopic{.name = text_at(rows.get(), 1),
                                 .type = text_at(rows.get(), 2),
                                 .encoding = text_at(rows.get(), 3)});
  }
}

void SqliteStorage::visit(FunctionRef<void(const BagMessage&)> use) {
  const Statement rows = prepare("SELECT id, topic_id, timestamp, data FROM messages NOT INDEXED");
  Increasing ids;
  std::uint64_t bytes = 0;
  while (step(rows.get())) {
    const std::int64_t id = sqlite3_column_int64(rows.get(), 0);
    if (!ids.accept(id)) throw damaged(fmt::format("message {} comes twice or out of order", id));
    const std::int64_t topic_id = sqlite3_column_int64(rows.get(), 1);
    const auto topic = topics_.find(topic_id);
    if (topic == topics_.end()) {
      throw damaged(
          fmt::format("message {} is of topic {}, which the table of topics does not "
                      "hold",
                      id, topic_id));
    }
    const auto data = bytes_at(rows.get(), 3);
    bytes += data.size() + kLeastRow;
    if (bytes > file_size_) {
      throw damaged(fmt::format("its messages up to {} take {} bytes, and the file has {}", id,
                                bytes, file_size_));
    }
    use({.topic = &topic->second,
         .recorded = sqlite3_column_int64(rows.get(), 2),
         .data = data,
         .place = {.unit = static_cast<std::uint64_t>(id), .offset = 0, .size = data.size()}});
  }
}

std::span<const std::byte> SqliteStorage::read(const BagPlace& place) {
  if (!reader_) reader_ = prepare("SELECT data FROM messages NOT INDEXED WHERE id = ?1");
  sqlite3_reset(reader_.get());
  sqlite3_bind_int64(reader_.get(), 1, static_cast<std::int64_t>(place.unit));
  if (!step(reader_.get())) {
    throw damaged(fmt::format("message {} was there, and is not any more", place.unit));
  }
  return bytes_at(reader_.get(), 0);
}

std::vector<BagTopic> SqliteStorage::topics() const {
  std::vector<BagTopic> topics;
  for (const auto& [id, topic] : topics_) topics.push_back(topic);
  return topics;
}

}  // namespace rmap
