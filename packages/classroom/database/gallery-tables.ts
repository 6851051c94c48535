/** A snapshot of a project that a pupil has shared with the class. */
export interface SharedTable {
  id: string
  class: string
  pupil: string
  /** Id that the device gave it: sent twice, it is one. */
  sent: string
  title: string
  card: string | null
  at: number
  bytes: number
  /** Has its program a network? */
  brain: 0 | 1
  /** The project without the content of its assets and without its child's progress. */
  document: string
  /** Its world as JSON: the list draws its picture from it. */
  world: string
  /** JSON: ids of what it was made from, the oldest first. What of it is gone stays as an id that nothing has. */
  chain: string
  /** Put out of sight by the teacher. */
  hidden: 0 | 1
  /** It shows a photo of its own, and the teacher has not agreed yet. */
  waiting: 0 | 1
}

interface SharedAssetTable {
  shared: string
  class: string
  /** By which the project names it. */
  name: string
  /** Of its content. */
  hash: string
}

interface HeartTable {
  shared: string
  pupil: string
}

/** What a pupil asks a classmate who has finished a card; one at a time. */
interface PeerQuestionTable {
  pupil: string
  class: string
  to: string
  card: string
  at: number
  /** Null: not answered yet. */
  answer: 'coming' | 'notNow' | null
}

export interface GalleryTables {
  shared: SharedTable
  sharedAsset: SharedAssetTable
  heart: HeartTable
  peerQuestion: PeerQuestionTable
}
