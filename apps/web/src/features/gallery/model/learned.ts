import { withLearnedWay, type MapFile } from '@botgarten/maps'
import { learningIn, type Project } from '@botgarten/programs'
import { loadStage } from '#figures/map/stage.ts'

/** More moves than this are not learned while a child waits to look. */
const mostMoves = 100_000

const mapIn =
  ({ maps }: Project) =>
  async (id: string): Promise<MapFile | null> =>
    (await loadStage(id, maps))?.map ?? null

/** A project that learns by trying, as it drives once it has learned; null: there is nothing to drive. */
export async function afterLearning(project: Project, mapOf = mapIn(project)): Promise<Project | null> {
  const program = project.world.robots[0]?.program ?? ''
  const own = project.programs[program]
  const outline = own ? learningIn(own) : null
  if (!outline || outline.moves > mostMoves) return null
  const map = await mapOf(outline.map)
  if (!map) return null
  try {
    const learned = withLearnedWay(project, () => map, project.q?.[program]?.seed)
    return learned === project ? null : learned
  } catch (cause) {
    // The map has no such station: the lab says so at the block.
    if (!(cause instanceof RangeError)) throw cause
    return null
  }
}
