import type { Facts } from '@botgarten/blocks'

/** Why a file was refused; worded as `problem.<reason>.title` and `.text`, with the error's facts. */
export type ProjectReason =
  'notJson' | 'tooBig' | 'notAProject' | 'newerVersion' | CardReason | SceneReason | OpenRobertaReason

/** A card's own: it is none, is newer, holds tags, an unknown check, numbers that cannot be, or lacks words. */
type CardReason = 'notACard' | 'newerCard' | 'cardTags' | 'cardCheck' | 'cardNumbers' | 'cardWords'

/** A scene's own: the file is none, it is a project, or more is in it than a world holds (`count`, `most`). */
type SceneReason = 'sceneNotJson' | 'notAScene' | 'isAProject' | 'tooManyThings'

/** An Open Roberta file's own: no XML at `line`, more than data, another format, another `robot`, too large (`most`). */
type OpenRobertaReason =
  'notXml' | 'unsafeXml' | 'notOpenRoberta' | 'otherRobot' | 'tooManyBlocks' | 'tooDeep'

/** The limit that is passed, and in which block, where it is one. `most`: bytes, levels, letters or entries. */
export interface Limit {
  readonly kind: 'size' | 'depth' | 'text' | 'name' | 'count'
  readonly most: number
  readonly block?: string
}

/** The only error that `parseProject`, `parseScene` and `readOpenRoberta` throw. `message` is for people who build and for the command line. */
export class ProjectError extends Error {
  override readonly name = 'ProjectError'
  readonly reason: ProjectReason
  readonly facts: Facts
  /** Where it is too much rather than no project. */
  readonly limit: Limit | undefined

  constructor(reason: ProjectReason, message: string, facts: Facts = {}, limit?: Limit) {
    super(message)
    this.reason = reason
    this.facts = facts
    this.limit = limit
  }
}
