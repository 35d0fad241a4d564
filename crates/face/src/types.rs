//! The exact TypeScript types of the face: `scenes.d.ts`, `catalogue.d.ts`, `types.d.ts` and `batches.d.ts`, and a name for each that
//! crosses the boundary.

use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const SCENES: &str = include_str!("scenes.d.ts");

#[wasm_bindgen(typescript_custom_section)]
const CATALOGUE: &str = include_str!("catalogue.d.ts");

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.d.ts");

#[wasm_bindgen(typescript_custom_section)]
const BATCHES: &str = include_str!("batches.d.ts");

#[wasm_bindgen]
extern "C" {
    /// `Setup`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Setup")]
    pub type JsSetup;
    /// `LinkSetup`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "LinkSetup")]
    pub type JsLinkSetup;
    /// `Scene`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Scene")]
    pub type JsScene;
    /// `Kind`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Kind")]
    pub type JsKind;
    /// `ParameterValue`, as `catalogue.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "ParameterValue")]
    pub type JsParameterValue;
    /// `Record<string, ParameterValue>`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Record<string, ParameterValue>")]
    pub type JsParameters;
    /// `Record<string, number>`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Record<string, number>")]
    pub type JsReadings;
    /// `Trace`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Trace")]
    pub type JsTrace;
    /// `FrameViews`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "FrameViews")]
    pub type JsFrame;
    /// `Drive | null`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Drive | null")]
    pub type JsDriveOrNull;
    /// `Motion | null`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Motion | null")]
    pub type JsMotionOrNull;
    /// `Record<string, ParameterValue> | undefined`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Record<string, ParameterValue> | undefined")]
    pub type JsGiven;
    /// `Outcome`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Outcome")]
    pub type JsOutcome;
    /// `Suggestion | null`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Suggestion | null")]
    pub type JsSuggestionOrNull;
    /// `Item`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Item")]
    pub type JsItem;
    /// `Item | null`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Item | null")]
    pub type JsItemOrNull;
    /// `Inspection | null`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Inspection | null")]
    pub type JsInspectionOrNull;
    /// `{ length: number; path: Point[] } | null`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "{ length: number; path: Point[]; tip_path?: Point3[] } | null")]
    pub type JsExactOrNull;
    /// `Status`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Status")]
    pub type JsStatus;
    /// `string`, checked before it is read.
    #[wasm_bindgen(typescript_type = "string")]
    pub type JsText;
    /// `boolean`, checked before it is read.
    #[wasm_bindgen(typescript_type = "boolean")]
    pub type JsFlag;
    /// `CanvasContext`, as `types.d.ts` describes it, checked before it is used.
    #[wasm_bindgen(typescript_type = "CanvasContext")]
    pub type JsContext;
    /// `number`, checked before it is read.
    #[wasm_bindgen(typescript_type = "number")]
    pub type JsNumber;
    /// `Point`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Point")]
    pub type JsPoint;
    /// `string[]`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "string[]")]
    pub type JsNames;
    /// `Point | undefined`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Point | undefined")]
    pub type JsPointOrUndefined;
    /// `LayerImage | null`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "LayerImage | null")]
    pub type JsLayerImageOrNull;
    /// `Subtask[]`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Job[]")]
    pub type JsJobs;
    /// A job and its scene.
    #[wasm_bindgen(typescript_type = "Setup & Pick<Job, 'ends'>", extends = JsSetup)]
    pub type JsRun;
    /// `Stage[]`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Stage[]")]
    pub type JsStages;
    /// `RunEvent[]`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "RunEvent[]")]
    pub type JsEvents;
    /// `SubtaskResult[]`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Finding[]")]
    pub type JsFindings;
    /// `SubtaskResult`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Finding")]
    pub type JsFinding;
    /// `NamedFile` or null, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "NamedFile | null")]
    pub type JsNamedFileOrNull;
    /// `NamedFile[]`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "NamedFile[]")]
    pub type JsNamedFiles;
    /// `Imported`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Imported")]
    pub type JsImported;
    /// `'movingai' | 'ros' | 'tsplib' | 'csv' | 'json'`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Format")]
    pub type JsFormat;
    /// `ArmPose`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "ArmPose")]
    pub type JsArmPose;
    /// `ArmSolutions`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "ArmSolutions")]
    pub type JsArmSolutions;
    /// `Reachability`, as `types.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Reachability")]
    pub type JsReachability;
    /// `Scene | string`, a scene or the name of one that ships.
    #[wasm_bindgen(typescript_type = "Scene | string")]
    pub type JsSceneOrName;
    /// `Point3`, as `scenes.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Point3")]
    pub type JsPoint3;
    /// `Point3 | null`, as `scenes.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Point3 | null")]
    pub type JsPoint3OrNull;
    /// `number[]`, six joints in degrees.
    #[wasm_bindgen(typescript_type = "number[]")]
    pub type JsJoints;
    /// `number[] | undefined`, six joints in degrees.
    #[wasm_bindgen(typescript_type = "number[] | undefined")]
    pub type JsJointsOrUndefined;
    /// `TrialRecord`, as `batches.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "TrialRecord")]
    pub type JsTrialRecord;
    /// `TrialCurve`, as `batches.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "TrialCurve")]
    pub type JsTrialCurve;
    /// `Group[]`, as `batches.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Group[]")]
    pub type JsGroups;
    /// `Comparison`, as `batches.d.ts` describes it.
    #[wasm_bindgen(typescript_type = "Comparison")]
    pub type JsComparison;
}
