import * as v from 'valibot'
import { handOut } from '#storage/handout.ts'
import type { Pupil } from './answers.ts'
import type { ClassApi } from './api.ts'

/** All about a pupil as a file. @throws Refused */
export async function saveEverything(api: ClassApi, classId: string, { id, nickname }: Pupil): Promise<void> {
  const all = await api.ask(v.unknown(), 'GET', `/classes/${classId}/pupils/${id}/everything`)
  handOut(nickname, JSON.stringify(all, null, 2), 'json')
}
