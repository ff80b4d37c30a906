//! Files that are whole or not there: written aside, then renamed.

use std::ffi::{OsStr, OsString};
use std::fs::{self, File, OpenOptions};
use std::io::{self, ErrorKind, Write};
use std::path::{Path, PathBuf};
use tempfile::{Builder, NamedTempFile};

/// Writes a file so that its name stands for the old content or for the new one, never for a part of
/// either: the bytes go to a file beside it, which is then renamed. Folders are made where they are
/// missing.
///
/// A link keeps its place, and the file that it names is replaced. What is no regular file, such as a
/// pipe or a terminal, is written to as it is. A file that exists keeps its permissions.
pub fn save(path: &Path, bytes: &[u8]) -> io::Result<()> {
    fs::create_dir_all(folder_of(path))?;
    let Some(path) = regular(path)? else {
        return fs::write(path, bytes);
    };
    let old = match OpenOptions::new().write(true).open(&path) {
        Ok(old) => Some(old),
        Err(e) if e.kind() == ErrorKind::NotFound => None,
        Err(e) => return Err(e),
    };
    let mut aside = match aside(&path) {
        Ok(aside) => aside,
        // The folder takes no new file, but the old one may be written to.
        Err(e) if e.kind() == ErrorKind::PermissionDenied && old.is_some() => {
            return fs::write(&path, bytes);
        }
        Err(e) => return Err(e),
    };
    aside.as_file_mut().write_all(bytes)?;
    if let Some(old) = old {
        aside
            .as_file()
            .set_permissions(old.metadata()?.permissions())?;
    }
    sync(aside.as_file())?;
    match aside.persist(&path) {
        Ok(_) => Ok(()),
        // A file that is mounted by itself cannot be replaced.
        Err(e) if e.error.kind() == ErrorKind::ResourceBusy => fs::write(&path, bytes),
        Err(e) => Err(e.error),
    }
}

/// Removes what a process that was killed while it wrote this file left beside it.
///
/// Not for a file that another process may be writing.
pub fn sweep(path: &Path) -> io::Result<()> {
    let Some((path, prefix)) = regular(path)?.and_then(|path| {
        let prefix = aside_prefix(&path)?;
        Some((path, prefix))
    }) else {
        return Ok(());
    };
    for entry in fs::read_dir(folder_of(&path))? {
        let entry = entry?;
        let name = entry.file_name();
        let random = name
            .as_encoded_bytes()
            .strip_prefix(prefix.as_encoded_bytes())
            .and_then(|rest| rest.strip_suffix(ASIDE_SUFFIX.as_bytes()));
        if random.is_some_and(|random| random.len() == RANDOM) {
            fs::remove_file(entry.path())?;
        }
    }
    Ok(())
}

/// Writes a file into the folder for temporary files, under a name that no other file has; returns its
/// path.
pub(super) fn keep(stem: &OsStr, ending: &str, bytes: &[u8]) -> io::Result<PathBuf> {
    let mut prefix = stem.to_owned();
    prefix.push("-");
    let suffix = format!(".{ending}");
    let kept = Builder::new().prefix(&prefix).suffix(&suffix).tempfile();
    let mut kept = kept.map_err(|e| io::Error::from(e.kind()))?;
    kept.as_file_mut().write_all(bytes)?;
    sync(kept.as_file())?;
    Ok(kept.keep().map_err(|e| e.error)?.1)
}

/// Checks that [`save`] can write here, and leaves nothing behind but the folders.
pub fn can_save(path: &Path) -> io::Result<()> {
    fs::create_dir_all(folder_of(path))?;
    let Some(path) = regular(path)? else {
        return Ok(());
    };
    match OpenOptions::new().write(true).open(&path) {
        Ok(_) => Ok(()),
        Err(e) if e.kind() == ErrorKind::NotFound => aside(&path).map(drop),
        Err(e) => Err(e),
    }
}

/// The longest chain of links that is followed.
const LONGEST_CHAIN: usize = 40;

/// The regular file, there already or not, that a path stands for in the end; `None` for anything else.
fn regular(path: &Path) -> io::Result<Option<PathBuf>> {
    let mut at = path.to_owned();
    for _ in 0..LONGEST_CHAIN {
        // Names of what is already open, which must not be replaced.
        if at.starts_with("/dev/fd") || at.starts_with("/proc") {
            return Ok(None);
        }
        match fs::read_link(&at) {
            Ok(next) => at = folder_of(&at).join(next),
            Err(_) => {
                return match fs::metadata(&at) {
                    Ok(found) if found.is_dir() => Err(ErrorKind::IsADirectory.into()),
                    Ok(found) if !found.is_file() => Ok(None),
                    _ => Ok(Some(at)),
                };
            }
        }
    }
    Err(io::Error::other("too many links"))
}

/// The folder that a file lies in.
fn folder_of(path: &Path) -> &Path {
    match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

/// What the names of files that are written aside begin and end with, and how many random letters they have.
const ASIDE: &str = ".halfdisk-";
const ASIDE_SUFFIX: &str = ".part";
const RANDOM: usize = 6;
/// A longer name cannot be a part of another one: names have 255 bytes at most.
const LONGEST_NAME: usize = 200;

/// What the names of files that are written aside for this one, and for no other, begin with.
fn aside_prefix(path: &Path) -> Option<OsString> {
    let name = path.file_name().filter(|name| name.len() <= LONGEST_NAME)?;
    Some(
        [OsStr::new(ASIDE), name, OsStr::new("-")]
            .into_iter()
            .collect(),
    )
}

/// An empty file in the same folder, gone again unless it is renamed.
fn aside(path: &Path) -> io::Result<NamedTempFile<File>> {
    let prefix = aside_prefix(path);
    let prefix = prefix.as_deref().unwrap_or(OsStr::new(ASIDE));
    let mut builder = Builder::new();
    builder.prefix(prefix).suffix(ASIDE_SUFFIX);
    builder.rand_bytes(RANDOM);
    // Readable like any other new file: less what the user's mask takes away.
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    // The crate's errors name this file, which nobody asked about.
    let made = builder.tempfile_in(folder_of(path));
    made.map_err(|e| e.kind().into())
}

/// Asks the file system to keep what was written. Some find out only here that there is no room; some
/// cannot be asked.
fn sync(file: &File) -> io::Result<()> {
    match file.sync_data() {
        Err(e) if matches!(e.kind(), ErrorKind::InvalidInput | ErrorKind::Unsupported) => Ok(()),
        result => result,
    }
}
