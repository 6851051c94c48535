import * as v from 'valibot'
import { handOut } from '#storage/handout.ts'
import type { Pupil } from './answers.ts'
import type { ClassApi } from './api.ts'

const anything = v.unknown()
const inLines = (value: unknown) => JSON.stringify(value, null, 2)

/** All about a pupil as a file, for parents who ask. @throws Refused */
export async function saveEverything(api: ClassApi, classId: string, { id, nickname }: Pupil): Promise<void> {
  const all = await api.ask(anything, 'GET', `/classes/${classId}/pupils/${id}/everything`)
  handOut(nickname, inLines(all), 'json')
}

/** A class with all its pupils' work as one file. @throws Refused */
export async function saveClass(
  api: ClassApi,
  { id, name }: { readonly id: string; readonly name: string },
  pupils: readonly Pupil[],
): Promise<void> {
  const all: unknown[] = []
  // One after the other: a class may be hundreds of megabytes on the server's side.
  for (const pupil of pupils)
    all.push(await api.ask(anything, 'GET', `/classes/${id}/pupils/${pupil.id}/everything`))
  handOut(name, inLines({ class: name, pupils: all }), 'json')
}
