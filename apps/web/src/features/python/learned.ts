import { learnedFor } from '@botgarten/maps'
import { learningIn, type Learned as Course, type Program, type Project } from '@botgarten/programs'
import type { Learned } from '@botgarten/programs/python'
import { loadStage } from '#figures/map/stage.ts'

/** What a program has learned by trying: its map has to come first. */
export async function learnedIn(
  program: Program,
  course: Course | undefined,
  maps: Project['maps'] = {},
): Promise<Learned> {
  const outline = learningIn(program)
  const stage = outline && (await loadStage(outline.map, maps))
  return stage ? learnedFor(program, () => stage.map, course) : {}
}
