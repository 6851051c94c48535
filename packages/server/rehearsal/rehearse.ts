import { randomBytes } from 'node:crypto'
import { mkdtempSync, rmSync } from 'node:fs'
import { join } from 'node:path'
import { prepareDataFolder } from '../data-folder.ts'
import { playLesson, type Figures, type LessonOptions } from './lesson.ts'
import { startNode } from './node.ts'
import { ownSchema } from './schema.ts'

export interface Rehearsal extends Pick<LessonOptions, 'pupils' | 'seconds' | 'hear' | 'signal'> {
  /** Beside its data, on the same disk, the rehearsal has a folder of its own, which is removed afterwards. */
  readonly data: string
  readonly database?: string | undefined
}

/** What a rehearsal must keep to be green. */
export const limits = { lost: 0, p99: 500 } as const

export const isGreen = ({ lost, p99, saves }: Figures): boolean =>
  saves > 0 && lost <= limits.lost && p99 <= limits.p99

/** Plays a lesson on this machine, disk and database; nothing of it stays. @throws where its signal ends it */
export async function rehearse({ data, database, ...lesson }: Rehearsal): Promise<Figures> {
  const folder = mkdtempSync(join(prepareDataFolder(data), 'rehearsal-'))
  const name = `rehearsal_${randomBytes(6).toString('hex')}`
  const schema = database === undefined ? null : await ownSchema(database, name)
  try {
    const node = await startNode({ data: folder, database: schema?.address })
    try {
      return await playLesson({ ...lesson, url: node.url, token: node.token(), every: 5 })
    } finally {
      await node.stop()
    }
  } finally {
    await schema?.remove()
    rmSync(folder, { recursive: true, force: true })
  }
}
