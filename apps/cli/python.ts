import { content } from '@botgarten/content/files'
import { learnedFor } from '@botgarten/maps'
import { mapLookup } from '@botgarten/maps/lookup'
import type { Project } from '@botgarten/programs'
import { centresIn, pythonFrom, type Dialect } from '@botgarten/programs/python'
import type { RobotPlacement } from '@botgarten/simulation'
import { findMap } from './maps.ts'
import { labMessage } from './words.ts'

const mapNamed = (id: string) => (content.maps.includes(id) ? findMap(id) : null)

/** A robot's program as Python, in the language of the call: the same bytes as the screen's. */
export function pythonOf(
  project: Project,
  robot: RobotPlacement,
  how: { readonly dialect: Dialect; readonly gaps: boolean; readonly learner: boolean },
): string {
  const program = project.programs[robot.program]!
  const learned = project.q?.[robot.program]
  const input = {
    ...{
      name: project.name,
      program,
      config: robot.config,
      brains: project.brains,
      ...(project.tables && { tables: project.tables }),
      set: robot.brain,
    },
    ...how,
    learned: {
      ...learnedFor(program, mapLookup(project, mapNamed), learned),
      centres: centresIn(project.sorting),
    },
  }
  return pythonFrom(input, labMessage).text
}
