export type { BlockType } from './packs/packs.ts'
export { addBlocks, definitions, isBlockType, packOf, toolbox } from './definitions.ts'
export { colours } from './parts/colours.ts'
export { sensorPortIn } from './parts/fields.ts'
export { entryOf, isKind, kinds, listOf } from './parts/kinds.ts'
export {
  hiddenIn,
  hiddenType,
  inputListOf,
  mostInLayer,
  mostNeurons,
  type HiddenLayer,
} from './parts/layers.ts'
export { nearestOption, optionFor } from './parts/options.ts'
export {
  knowMaps,
  knowOwnMaps,
  mapEnds,
  knownMaps,
  mapField,
  mapIn,
  mostEpisodes,
  mostMoves,
  openMaps,
  ownMapIn,
  type KnownMaps,
} from './parts/maps.ts'
export { executeOrders, hertzPerLevel } from './parts/orders.ts'
export { filledRows, plugged, rowCount, rowName } from './parts/rows.ts'
export { speechLength } from './parts/speech.ts'
export { emptySorting } from './parts/empty-sorting.ts'
export { nothing } from './parts/texts.ts'
export { binds, whole } from './python.ts'
export type { Expression, Python, PythonAt, RobotPython } from './python.ts'
export { blockFrom, stacksOf } from './template.ts'
export type { ToolboxCategory } from './toolbox.ts'
export type * from './types.ts'
