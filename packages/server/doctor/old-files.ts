import { existsSync, statSync } from 'node:fs'
import { join } from 'node:path'
import { lastBackup } from '@botgarten/classroom'
import { inRepository } from '../repository.ts'

const writtenAt = (file: string | null) => (file !== null && existsSync(file) ? [statSync(file).mtimeMs] : [])

/** When files were written that are certainly older than now: the product, and what a server of it has saved. */
export const oldFiles = (data: string) =>
  [inRepository('package.json'), join(data, 'botgarten.db'), lastBackup(data)?.file ?? null].flatMap(
    writtenAt,
  )

/**
 * The time as far as this machine can know it: a clock that was never set is behind what was written already. ms since 1970
 */
export const timeAtLeast = (data: string, now: number): number => Math.max(now, ...oldFiles(data))
