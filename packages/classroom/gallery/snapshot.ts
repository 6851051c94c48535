import type { Project } from '@botgarten/programs/project'
import type { Checked } from '../projects/checked.ts'

/** What is shown of a project in a list. */
interface Snapshot {
  /** The project as JSON, its assets and its child's progress left out. */
  readonly document: string
  /** Its world as JSON, small enough for a list. */
  readonly world: string
  /** Has its program a network? */
  readonly brain: 0 | 1
  /** Ids of what it was made from, the oldest first. */
  readonly chain: readonly string[]
}

/** A larger world is drawn as its floor with the robots. */
const mostWorld = 40_000
/** So many of those before stay in a chain. */
const mostChain = 20

const plain = ({ world }: Project) => {
  const all = JSON.stringify(world)
  return all.length <= mostWorld ? all : JSON.stringify({ ...world, areas: [], lines: [], obstacles: [] })
}

/** @param checked a project that the parser has let through */
export function snapshotOf({ document }: Pick<Checked, 'document'>): Snapshot {
  const { progress: _, madeFrom = [], ...project } = JSON.parse(document) as Project
  const chain = madeFrom.map(({ id }) => id).slice(-mostChain)
  const brain = Object.keys(project.brains).length > 0 ? 1 : 0
  return { document: JSON.stringify(project), world: plain(project), brain, chain: [...new Set(chain)] }
}
