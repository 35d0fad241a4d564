//! Scenes from and for other programs' files.

use js_sys::{Array, Uint8Array};
use wasm_bindgen::{JsCast, prelude::*};

use forage::{
    Error, Scene,
    kernel::{allowed, limits},
};
use forage_formats::{self as formats, Format, NamedFile, tour_file};

use crate::{
    JsFormat, JsImported, JsNamedFileOrNull, JsNamedFiles, JsNumber, JsScene, Session, js_error, object, plain,
    read::{in_memory, property, read_list, read_scene, read_text, refused, typed_array, whole},
    registry::ask,
    tool::Tool,
};

struct Files {
    import: fn(&[NamedFile], Option<usize>) -> Result<JsImported, JsValue>,
    export: fn(&Scene, &str) -> Result<Vec<NamedFile>, Error>,
    tour: fn(&str, &[usize]) -> NamedFile,
}

static FILES: Tool<Files> = Tool::new("files");

/// Offers other programs' files.
pub fn offer_files() {
    FILES.offer(&Files {
        import: |files, problem| plain(&ask(|registry| formats::import(registry, files, problem))?),
        export: |scene, format| {
            let made = formats::export(scene, Format::named(format)?, scene.name())?;
            Ok(made.files)
        },
        tour: tour_file,
    });
}

/// The scene in some files: a `.map`, alone or with a `.scen`; a `.yaml` with its `.pgm`; a `.tsp` or a scene's `.json`,
/// alone or with a `.tour`; or a `.csv` of points. Of a `.scen` file's problems the scene takes the one with this number,
/// from 0; the last one if none is asked for. A tour is measured, and kept as the scene's optimum if it is an `.opt.tour`.
///
/// # Errors
/// An `Error` whose `field` is the file and whose message says in which line what is wrong, or which file is missing.
#[wasm_bindgen(js_name = importScene)]
pub fn import_scene(files: &JsNamedFiles, problem: Option<JsNumber>) -> Result<JsImported, JsValue> {
    let mut size = 0;
    let files = read_list("files", files)?.iter().map(|file| read_file(file, &mut size)).collect::<Result<Vec<_>, _>>()?;
    let problem = problem.map(|number| whole("problem", &number)).transpose()?.map(in_memory);
    (FILES.get()?.import)(&files, problem)
}

/// A scene's files in another format.
///
/// # Errors
/// For an unknown format, and for scenes of a kind that it does not hold.
#[wasm_bindgen(js_name = exportScene)]
pub fn export_scene(scene: &JsScene, format: &JsFormat) -> Result<JsNamedFiles, JsValue> {
    let scene = read_scene(scene)?;
    let format = read_text("format", format)?;
    let made = (FILES.get()?.export)(&scene, &format).map_err(js_error)?;
    let files = Array::new();
    for file in made {
        files.push(&named_file::<JsValue>(file));
    }
    Ok(files.unchecked_into())
}

/// A file as an object.
fn named_file<T: JsCast>(file: NamedFile) -> T {
    let bytes = Uint8Array::from(file.bytes.as_slice());
    object(&[("name", file.name.into()), ("bytes", bytes.into())])
}

/// A file, refused before it is copied where it and those before it, of `size` bytes together, are too large.
fn read_file(value: &JsValue, size: &mut usize) -> Result<NamedFile, JsValue> {
    let bytes = property(value, "bytes");
    let Some(bytes) = typed_array::<Uint8Array>(&bytes) else {
        return Err(refused("bytes", &bytes, allowed::bytes()));
    };
    let name = read_text("name", &property(value, "name"))?;
    *size = size.saturating_add(bytes.length() as usize);
    limits::check_bytes(&name, *size, limits::FILE_BYTES).map_err(js_error)?;
    Ok(NamedFile { name, bytes: bytes.to_vec() })
}

#[wasm_bindgen]
impl Session {
    /// The best tour so far as a TSPLIB `.tour` file; null where no tour was found.
    #[wasm_bindgen(js_name = tourFile)]
    /// # Errors
    /// Where files are not offered.
    pub fn tour_file(&mut self) -> Result<JsNamedFileOrNull, JsValue> {
        let Some(order) = self.run.outcome().order else {
            return Ok(JsValue::NULL.unchecked_into());
        };
        Ok(named_file((FILES.get()?.tour)(&format!("{}.tour", self.run.scene().name()), &order)))
    }
}
