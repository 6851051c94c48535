import type { Document } from '@botgarten/lab'
import { emptyBrain, type Brain } from '@botgarten/learning/neural-network/brain'
import type { TableBrain } from '@botgarten/learning/q-senses'
import {
  sceneOf,
  type Learned,
  type Program,
  type Progress,
  type Project,
  type Scene,
} from '@botgarten/programs'
import type { Pose, RobotConfig } from '@botgarten/simulation'

/** By the ids of robots and things. */
type Poses = { readonly [id: string]: Pose }

interface Placed {
  readonly id: string
  readonly pose: Pose
}

/** Where everything of a world, or of a view of one, stands. */
const posesOf = ({ robots, obstacles }: { robots: readonly Placed[]; obstacles: readonly Placed[] }): Poses =>
  Object.fromEntries([...robots, ...obstacles].map(({ id, pose }) => [id, pose]))
import type { RunningLab } from './running.svelte.ts'

/** What is to become of a part of the project, as data. It happens through `LabSession.apply` and in no other way. */
export type Change =
  /** What a program says; the blocks that say so are already where they are seen. */
  | { readonly kind: 'program'; readonly program: string; readonly after: Program }
  /** One step of the blocks themselves, which Blockly takes back and forth. */
  | { readonly kind: 'blocks'; readonly program: string; readonly direction: 'undo' | 'redo' }
  /** Where a robot or a thing stands. `start`: where a run that begins puts it, if not there. */
  | { readonly kind: 'place'; readonly id: string; readonly after: Pose; readonly start?: Pose | undefined }
  | WeightChange
  /** All weights of a network, in every set. */
  | { readonly kind: 'brain'; readonly id: string; readonly after: Brain }
  /** What a network was shown: rows set aside, wishes changed, drives thrown away, files opened. Undefined: nothing. */
  | { readonly kind: 'examples'; readonly network: string; readonly after: Brain['examples'] | undefined }
  /** How a network practised last and practises next. Its weights stay. */
  | { readonly kind: 'practice'; readonly network: string; readonly after: Brain['practice'] | undefined }
  /** What a robot has learned by trying with its sensors, by the id of its block. Null: nothing. */
  | { readonly kind: 'table'; readonly id: string; readonly after: TableBrain | null }
  /** What a robot is built of. */
  | { readonly kind: 'config'; readonly id: string; readonly after: RobotConfig }
  /** Floor, size and things. `pictures`: new ones that lie in it; `stood`: where everything is put. */
  | {
      readonly kind: 'scene'
      readonly after: Scene
      readonly pictures?: Project['assets']
      readonly stood?: Poses
    }
  /** Which robots there are, with their programs and brains. */
  | { readonly kind: 'robots'; readonly after: Document; readonly stood?: Poses }
  /** The other future takes the place of this one (running.md 9). */
  | { readonly kind: 'future' }
  /** What a program has learned by trying. */
  | { readonly kind: 'learned'; readonly program: string; readonly after: Learned }
  /** How far a child has come with the card. */
  | { readonly kind: 'progress'; readonly after: Progress }
  /** Which blocks the shelf offers. */
  | { readonly kind: 'shelf'; readonly after: NonNullable<Project['shelf']> }

/** One weight, in the set that a robot drives with. */
interface WeightChange {
  readonly kind: 'weight'
  readonly network: string
  readonly from: string
  readonly to: string
  readonly after: number
  readonly set: string
}

/**
 * How a change counts for who takes it back: `whole` alone; `start`, `move` and `end` as the parts of one pull;
 * `joined` together with the step before it; `silent` not at all.
 */
export type Part = 'whole' | 'start' | 'move' | 'end' | 'joined' | 'silent'

/** What listeners of a session are told, after it has happened. */
export type LabEvent =
  /** `back`: takes it back; null where that is no step. `joined`: goes together with the step before it. */
  | {
      readonly kind: 'changed'
      readonly change: Change
      readonly back: Change | null
      readonly joined: boolean
    }
  /** A hand went on from this tick of the past: that is the present now (running.md 9). */
  | { readonly kind: 'branched'; readonly tick: number }
  /** A run has begun. */
  | { readonly kind: 'begun' }

/** The change that takes this one back, as things stand before it; null for what is taken back in no step. */
export function backFrom(
  change: Change,
  { document, view }: Pick<RunningLab, 'document' | 'view'>,
): Change | null {
  switch (change.kind) {
    case 'blocks':
      return { ...change, direction: change.direction === 'undo' ? 'redo' : 'undo' }
    case 'place': {
      const after = posesOf(view)[change.id]
      return after ? { ...change, after, start: posesOf(document.world)[change.id] } : null
    }
    case 'weight':
    case 'brain': {
      const id = change.kind === 'weight' ? change.network : change.id
      return { kind: 'brain', id, after: document.brains[id] ?? emptyBrain }
    }
    case 'examples':
      return { ...change, after: document.brains[change.network]?.examples }
    case 'practice':
      return { ...change, after: document.brains[change.network]?.practice }
    case 'table':
      return { ...change, after: document.tables?.[change.id] ?? null }
    case 'config': {
      const robot = document.world.robots.find(({ id }) => id === change.id)
      return robot ? { ...change, after: robot.config } : null
    }
    case 'scene':
      return { kind: 'scene', after: sceneOf(document.world), stood: posesOf(view) }
    case 'robots':
      return { kind: 'robots', after: document, stood: posesOf(view) }
    default:
      return null
  }
}
