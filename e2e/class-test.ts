import { classOfTest, nextClass } from './class-server.ts'
import { test as base } from './house.ts'
import type { MadeClass } from './made-class.ts'

type Language = 'en' | 'de'

/** A class for one test. Tests move the clock of the server that they share (asked-class.ts); it is set back afterwards. */
export async function lendClass(
  room: MadeClass,
  language: Language,
  use: (school: MadeClass) => Promise<void>,
): Promise<void> {
  const { ports } = room.classServer
  const { now, steady, day } = ports
  await use(await nextClass(room, language))
  Object.assign(ports, { now, steady, day })
}

/** Tests in a class of their own; a worker has one server for the classes of all files. */
const testsIn = (language: Language) =>
  base.extend<{ school: MadeClass }, { room: MadeClass }>({
    room: [
      // eslint-disable-next-line no-empty-pattern -- Playwright reads the names of what is asked for
      async ({}, use) => {
        const room = await classOfTest(language)
        await use(room)
        await room.close()
      },
      { scope: 'worker' },
    ],
    house: [({ room }, use) => use(room.url), { scope: 'worker' }],
    school: ({ room }, use) => lendClass(room, language, use),
  })

// The same test for every file: what is asked for otherwise would be a worker of its own.
const tests = { en: testsIn('en'), de: testsIn('de') }

export const testInClass = (language: Language = 'en') => tests[language]
