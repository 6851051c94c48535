// Maps that somebody draws: as documents, as SVG there and back, and what can be said of them.
export * from './edit.ts'
export { bridgesOf, bridgeStrokes } from './bridges.ts'
export { coverStrokes, photoAddress, sceneryOf, strokesOf, type Stroke } from './dress.ts'
export {
  bendPiece,
  faultsOf,
  lineOf,
  sampled,
  SHORTEST,
  TIGHTEST,
  type RoadFault,
  type RoadLine,
} from './line.ts'
export { labelArea, labelsOf, LARGEST, type StationLabel } from './labels.ts'
export { openMap, type OpenedMap } from './open.ts'
export { openRoads, reachOf, type Reach } from './reach.ts'
export { icy, writeMap } from './write.ts'
export {
  colourOf,
  emptyRooms,
  endsOf,
  furniture,
  kindOf,
  letterOf,
  resizeRooms,
  roomKinds,
  roomPlaces,
  roomsDrawn,
  setRoom,
  windArrows,
  type RoomKind,
} from './rooms.ts'
export { ownId } from './own-id.ts'
