// The process of a test file is ended from outside: what it has compiled is written down before (vitest.config.ts).
import { flushCompileCache } from 'node:module'
import { afterAll } from 'vitest'

afterAll(() => flushCompileCache())
