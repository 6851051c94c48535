import { classOfTest } from './class-server.ts'
import { test as base } from './house.ts'
import type { MadeClass } from './made-class.ts'

/** Tests in a class of their own, one for all tests that a worker takes of a file. */
export const testInClass = (language: 'en' | 'de' = 'en') =>
  base.extend<object, { school: MadeClass }>({
    school: [
      // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
      async ({}, use) => {
        const school = await classOfTest(language)
        await use(school)
        await school.close()
      },
      { scope: 'worker' },
    ],
    house: [({ school }, use) => use(school.url), { scope: 'worker' }],
  })
