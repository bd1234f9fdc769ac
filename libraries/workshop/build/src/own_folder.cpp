#include "own_folder.h"

#include <cerrno>
#include <string>
#include <system_error>

#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include "elsie/plugin/error.h"

namespace elsie::build {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void refuse(const fs::path& folder, const FolderUse& use, const std::string& problem) {
  throw plugin::PluginError("the folder " + folder.string() + " for " + use.content + " " +
                            problem + " in the environment variable " + use.variable);
}

[[noreturn]] void cannot_be_made(const fs::path& folder, const FolderUse& use, int error) {
  refuse(folder, use,
         "cannot be made: " + std::generic_category().message(error) + "; name another one");
}

/// Whether only this user and root decide what becomes of the file. In a user namespace, root's
/// files may have another owner; so has "/" then.
bool has_own_owner(const struct stat& status) {
  struct stat top {};
  return status.st_uid == geteuid() || status.st_uid == 0 ||
         (stat("/", &top) == 0 && status.st_uid == top.st_uid);
}

/// A group with the number of the owner has no other members, where each user has such a group.
bool others_may_write(const struct stat& status) {
  return (status.st_mode & S_IWOTH) != 0 ||
         ((status.st_mode & S_IWGRP) != 0 && status.st_gid != status.st_uid);
}

std::string name_of(uid_t user) {
  const passwd* const entry = getpwuid(user);  // of no consequence if another thread asks, too
  return entry ? entry->pw_name : "number " + std::to_string(user);
}

/// Refuses `folder` if another user can replace or fill it by this part of its path.
void check_part(const fs::path& folder, const FolderUse& use, const fs::path& part) {
  struct stat status {};
  if (lstat(part.c_str(), &status) != 0) {
    cannot_be_made(folder, use, errno);
  }
  const bool is_above = part != folder;
  const std::string which = is_above ? "is in " + part.string() + ", which " : "";
  const std::string advice =
      "; libraries that others put there would run as you: " +
      std::string(is_above ? "name a folder elsewhere" : "remove it, or name a folder of your own");
  if (!has_own_owner(status)) {
    refuse(folder, use,
           which + "belongs to another user (" + name_of(status.st_uid) + ")" + advice);
  }
  const bool is_sticky = is_above && (status.st_mode & S_ISVTX) != 0;
  if (S_ISDIR(status.st_mode) && !is_sticky && others_may_write(status)) {
    refuse(folder, use, which + "may be written by other users" + advice);
  }
}

/// Makes each missing part of the path, and checks it before the next one.
void make_checked(const fs::path& folder, const FolderUse& use) {
  fs::path part;
  for (const fs::path& name : folder) {
    part /= name;
    // Where nothing may be written, "/home" is refused although it exists.
    std::error_code ignored;
    if (mkdir(part.c_str(), S_IRWXU) != 0 && errno != EEXIST) {
      const int error = errno;
      if (!fs::is_directory(part, ignored)) {
        cannot_be_made(folder, use, error);
      }
    }
    check_part(folder, use, part);
  }
}

}  // namespace

fs::path own_folder(const fs::path& folder, const FolderUse& use) {
  const fs::path named = fs::absolute(folder);
  make_checked(named, use);  // also the links in it
  std::error_code error;
  fs::path real = fs::canonical(named, error);
  if (error || !fs::is_directory(real, error)) {
    cannot_be_made(named, use, error ? error.value() : ENOTDIR);
  }
  if (real != named) {
    make_checked(real, use);
  }
  return real;
}

bool is_own_file(const fs::path& file) {
  struct stat status {};
  return lstat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) && has_own_owner(status);
}

}  // namespace elsie::build
