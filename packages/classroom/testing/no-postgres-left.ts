import { rmSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'

/** Where the test files of a run find data of a PostgreSQL server that nobody has used. @param run the process that starts them */
export const unusedPostgres = (run: number): string => join(tmpdir(), `botgarten-unused-pg-${run}`)

/** Called when a run of tests ends (vitest.config.ts). */
export const teardown = (): void => rmSync(unusedPostgres(process.pid), { recursive: true, force: true })
