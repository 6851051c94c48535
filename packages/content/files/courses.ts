import type { LaneKind, Racer } from '@botgarten/experiments/brain-race'
import { readCourse, type CourseFile } from '../schema/course.ts'
import type { CardProgram } from '../schema/cardTypes.ts'
import { named, once, type Folder } from './folder.ts'

/** Courses on which brains race, with the brains that drive where nobody brings others. */
export function coursesIn(content: Folder, ofCard: (card: string, file: string) => CardProgram | null) {
  const courses = once(() =>
    content
      .foldersWith('courses/*/course.json')
      .map((folder) => named(folder, readCourse(content.json(folder, 'course.json')))),
  )
  const course = (id: string): CourseFile | null => courses().find((one) => one.id === id) ?? null
  /** Null where the course has none of this kind. */
  function racer(id: string, kind: LaneKind): Racer | null {
    const at = course(id)?.racers[kind]
    if (!at) return null
    const made =
      'card' in at
        ? ofCard(at.card, at.file)
        : (content.json('courses', id, `${at.file}.json`) as CardProgram)
    return made && { ...made, ...(at.effort && { effort: at.effort }) }
  }
  return { courses, racer }
}
