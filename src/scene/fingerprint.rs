//! A number that two scenes share where they are the same.

use super::Scene;
use sha2::{Digest, Sha256};
use std::fs;
use std::io;
use std::path::Path;

impl Scene {
    /// A fingerprint of what the scene was made from: 16 hexadecimal digits of the SHA-256 of its description, its
    /// camera and the contents of the files that it names. Spaces and comments of its file do not matter, nor where
    /// it lies.
    ///
    /// Fails where a file cannot be read any more.
    pub fn fingerprint(&self) -> io::Result<String> {
        let mut hash = Sha256::new();
        // Debug text has every field, and each number to the last bit.
        hash.update(format!(
            "{:?} {:?}",
            self.made_from.description, self.camera
        ));
        let folder = self.made_from.folder.as_deref().unwrap_or(Path::new(""));
        for file in self.made_from.description.files() {
            let bytes = fs::read(folder.join(file))?;
            hash.update((bytes.len() as u64).to_le_bytes());
            hash.update(bytes);
        }
        let digits = hash.finalize().into_iter().take(8);
        Ok(digits.map(|byte| format!("{byte:02x}")).collect())
    }
}
