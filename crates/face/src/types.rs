//! The TypeScript types of the face: `types.d.ts` of the Rust types (`forage list --types`), `objects.d.ts` of what has none, and
//! a name for each that crosses the boundary.

use wasm_bindgen::prelude::*;

#[wasm_bindgen(typescript_custom_section)]
const OBJECTS: &str = include_str!("objects.d.ts");

#[wasm_bindgen(typescript_custom_section)]
const TYPES: &str = include_str!("types.d.ts");

#[wasm_bindgen]
extern "C" {
    /// `Setup`.
    #[wasm_bindgen(typescript_type = "Setup")]
    pub type JsSetup;
    /// `LinkSetup`.
    #[wasm_bindgen(typescript_type = "LinkSetup")]
    pub type JsLinkSetup;
    /// `Scene`.
    #[wasm_bindgen(typescript_type = "Scene")]
    pub type JsScene;
    /// `Kind`.
    #[wasm_bindgen(typescript_type = "Kind")]
    pub type JsKind;
    /// `ParameterValue`.
    #[wasm_bindgen(typescript_type = "ParameterValue")]
    pub type JsParameterValue;
    /// `Record<string, ParameterValue>`.
    #[wasm_bindgen(typescript_type = "Record<string, ParameterValue>")]
    pub type JsParameters;
    /// `Record<string, number>`.
    #[wasm_bindgen(typescript_type = "Record<string, number>")]
    pub type JsReadings;
    /// `Trace`.
    #[wasm_bindgen(typescript_type = "Trace")]
    pub type JsTrace;
    /// `FrameViews`.
    #[wasm_bindgen(typescript_type = "FrameViews")]
    pub type JsFrame;
    /// `Drive | null`.
    #[wasm_bindgen(typescript_type = "Drive | null")]
    pub type JsDriveOrNull;
    /// `Motion | null`.
    #[wasm_bindgen(typescript_type = "Motion | null")]
    pub type JsMotionOrNull;
    /// `Record<string, ParameterValue> | undefined`.
    #[wasm_bindgen(typescript_type = "Record<string, ParameterValue> | undefined")]
    pub type JsGiven;
    /// `Outcome`.
    #[wasm_bindgen(typescript_type = "Outcome")]
    pub type JsOutcome;
    /// `Suggestion | null`.
    #[wasm_bindgen(typescript_type = "Suggestion | null")]
    pub type JsSuggestionOrNull;
    /// `Item`.
    #[wasm_bindgen(typescript_type = "Item")]
    pub type JsItem;
    /// `Item | null`.
    #[wasm_bindgen(typescript_type = "Item | null")]
    pub type JsItemOrNull;
    /// `Inspection | null`.
    #[wasm_bindgen(typescript_type = "Inspection | null")]
    pub type JsInspectionOrNull;
    /// `Exact | null`.
    #[wasm_bindgen(typescript_type = "Exact | null")]
    pub type JsExactOrNull;
    /// `Status`.
    #[wasm_bindgen(typescript_type = "Status")]
    pub type JsStatus;
    /// `Status | 'partly'`.
    #[wasm_bindgen(typescript_type = "Status | 'partly'")]
    pub type JsAdvanced;
    /// `string`, checked before it is read.
    #[wasm_bindgen(typescript_type = "string")]
    pub type JsText;
    /// `boolean`, checked before it is read.
    #[wasm_bindgen(typescript_type = "boolean")]
    pub type JsFlag;
    /// `CanvasContext`, checked before it is used.
    #[wasm_bindgen(typescript_type = "CanvasContext")]
    pub type JsContext;
    /// `Ramp`, checked before it is read.
    #[wasm_bindgen(typescript_type = "Ramp")]
    pub type JsRamp;
    /// `number`, checked before it is read.
    #[wasm_bindgen(typescript_type = "number")]
    pub type JsNumber;
    /// `Point`.
    #[wasm_bindgen(typescript_type = "Point")]
    pub type JsPoint;
    /// `LayerName[]`.
    #[wasm_bindgen(typescript_type = "LayerName[]")]
    pub type JsLayerNames;
    /// `LayerName`, checked before it is read.
    #[wasm_bindgen(typescript_type = "LayerName", extends = JsText)]
    pub type JsLayerName;
    /// `PlannerName`, checked before it is read.
    #[wasm_bindgen(typescript_type = "PlannerName", extends = JsText)]
    pub type JsPlannerName;
    /// `GeneratorName`, checked before it is read.
    #[wasm_bindgen(typescript_type = "GeneratorName", extends = JsText)]
    pub type JsGeneratorName;
    /// `Point | undefined`.
    #[wasm_bindgen(typescript_type = "Point | undefined")]
    pub type JsPointOrUndefined;
    /// `LayerImage | null`.
    #[wasm_bindgen(typescript_type = "LayerImage | null")]
    pub type JsLayerImageOrNull;
    /// `Subtask[]`.
    #[wasm_bindgen(typescript_type = "Job[]")]
    pub type JsJobs;
    /// A job and its scene.
    #[wasm_bindgen(typescript_type = "Setup & { ends?: [Point, Point] }", extends = JsSetup)]
    pub type JsRun;
    /// `Stage[]`.
    #[wasm_bindgen(typescript_type = "Stage[]")]
    pub type JsStages;
    /// `RunEvent[]`.
    #[wasm_bindgen(typescript_type = "RunEvent[]")]
    pub type JsEvents;
    /// `SubtaskResult[]`.
    #[wasm_bindgen(typescript_type = "Finding[]")]
    pub type JsFindings;
    /// `SubtaskResult`.
    #[wasm_bindgen(typescript_type = "Finding")]
    pub type JsFinding;
    /// `NamedFile` or null.
    #[wasm_bindgen(typescript_type = "NamedFile | null")]
    pub type JsNamedFileOrNull;
    /// `NamedFile[]`.
    #[wasm_bindgen(typescript_type = "NamedFile[]")]
    pub type JsNamedFiles;
    /// `Imported`.
    #[wasm_bindgen(typescript_type = "Imported")]
    pub type JsImported;
    /// `'movingai' | 'ros' | 'tsplib' | 'csv' | 'json'`.
    #[wasm_bindgen(typescript_type = "Format")]
    pub type JsFormat;
    /// `ArmPose`.
    #[wasm_bindgen(typescript_type = "ArmPose")]
    pub type JsArmPose;
    /// `ArmSolutions`.
    #[wasm_bindgen(typescript_type = "ArmSolutions")]
    pub type JsArmSolutions;
    /// `Reachability`.
    #[wasm_bindgen(typescript_type = "Reachability")]
    pub type JsReachability;
    /// `Scene | SceneName`, a scene or the name of one that ships.
    #[wasm_bindgen(typescript_type = "Scene | SceneName")]
    pub type JsSceneOrName;
    /// `Point3`.
    #[wasm_bindgen(typescript_type = "Point3")]
    pub type JsPoint3;
    /// `Point3 | null`.
    #[wasm_bindgen(typescript_type = "Point3 | null")]
    pub type JsPoint3OrNull;
    /// `number[]`, six joints in degrees.
    #[wasm_bindgen(typescript_type = "number[]")]
    pub type JsJoints;
    /// `number[] | undefined`, six joints in degrees.
    #[wasm_bindgen(typescript_type = "number[] | undefined")]
    pub type JsJointsOrUndefined;
    /// `TrialRecord`.
    #[wasm_bindgen(typescript_type = "TrialRecord")]
    pub type JsTrialRecord;
    /// `TrialCurve`.
    #[wasm_bindgen(typescript_type = "TrialCurve")]
    pub type JsTrialCurve;
    /// `Group[]`.
    #[wasm_bindgen(typescript_type = "Group[]")]
    pub type JsGroups;
    /// `Pick<TrialCurve, 'evaluations' | 'values'>[][]`.
    #[wasm_bindgen(typescript_type = "Pick<TrialCurve, 'evaluations' | 'values'>[][]")]
    pub type JsCurves;
    /// `number[]`.
    #[wasm_bindgen(typescript_type = "number[]")]
    pub type JsNumbers;
    /// `(number | null)[]`.
    #[wasm_bindgen(typescript_type = "(number | null)[]")]
    pub type JsReachedRuns;
    /// `Bands`.
    #[wasm_bindgen(typescript_type = "Bands")]
    pub type JsBands;
    /// `Reached`.
    #[wasm_bindgen(typescript_type = "Reached")]
    pub type JsReached;
    /// `Comparison`.
    #[wasm_bindgen(typescript_type = "Comparison")]
    pub type JsComparison;
}
