import type { Page } from '@playwright/test'
import { ProjectList } from '../child-projects.ts'
import type { Child } from '../child.ts'
import { freeProgram } from '../projects.ts'
import { expect, test } from '../gate/gate.ts'
import { goesThrough, type Steps } from '../steps.ts'

test.use({ language: 'en' })

/** When a project was changed, and its id. */
const hides = /(?<=· )(now|\d+ \w+ ago)|(?<=[?&]p=)[\w-]+/g

/** Leaves only the name and card of a project in the storage, as a fault of a disk might. */
const breaks = (page: Page, name: string) =>
  page.evaluate(async (broken) => {
    const done = <Result>(request: IDBRequest<Result>) =>
      new Promise<Result>((found) => (request.onsuccess = () => found(request.result)))
    const database = await done(indexedDB.open('botgarten'))
    const store = database.transaction('projects', 'readwrite').objectStore('projects')
    type Kept = { readonly project: { readonly name: string } }
    const all = (await done(store.getAll())) as readonly Kept[]
    const one = all.find(({ project }) => project.name === broken)!
    await done(store.put({ ...one, project: { name: broken, card: 'fear' } }))
    database.close()
  }, name)

/** The browser would ask before it keeps things for long, and then promises nothing. */
const promisesNothing = (page: Page) =>
  page.evaluate(() => {
    navigator.storage.persisted = () => Promise.resolve(false)
    navigator.storage.persist = () => Promise.resolve(false)
    navigator.permissions.query = () => Promise.resolve({ state: 'prompt' } as PermissionStatus)
  })

function listSteps(child: Child, list: ProjectList): Steps {
  const { page } = child
  const dialog = page.getByRole('dialog')
  const inDialog = (key: string) => dialog.getByRole('button', { name: child.word(key), exact: true })
  const name = page.getByRole('textbox', { name: child.word('projects.name'), exact: true })
  const search = page.getByRole('searchbox', { name: child.word('projects.search') })
  const opensFile = (file: string) =>
    list.opensFile(
      `${file}.json`,
      freeProgram(file, (make) => [make.wait(1)]),
    )
  const back = async () => {
    await child.seesLab()
    await list.opens()
  }
  /** A press hands a file out. */
  const saves = async (press: Promise<void> | void, act: () => Promise<void>, file: RegExp) => {
    await press
    const download = page.waitForEvent('download')
    await act()
    expect((await download).suggestedFilename()).toMatch(file)
  }
  return {
    'no projects': () => list.opens(),
    'a new one is asked for': () => child.presses('projects.new'),
    'its name is typed over the one that is offered': () => page.keyboard.type('Den'),
    'without a name none begins': () => name.fill(' '),
    'none after all': () => inDialog('projects.cancel').click(),
    'asked for again': () => child.presses('projects.new'),
    'none, by keys': () => child.types('Escape'),
    'an example began': async () => {
      await child.presses('projects.new')
      await dialog.getByRole('button', { name: child.card('forward') }).click()
      await back()
    },
    'the place for a new one': () => child.button('projects.empty').click(),
    'an empty one began': async () => {
      await name.fill('Den')
      await inDialog('projects.begin').click()
      await back()
    },
    'an example under a name of its own began': async () => {
      await child.presses('projects.new')
      await name.fill('Fox')
      await dialog.getByRole('button', { name: child.card('chameleon') }).click()
      await back()
    },
    'what can be done with one': async () => {
      await list
        .project('Den')
        .getByRole('button', { name: child.word('projects.more', { name: 'Den' }) })
        .click()
    },
    'its new name is asked for': () =>
      list
        .project('Den')
        .getByRole('button', { name: child.word('projects.rename') })
        .click(),
    'no name is none': () => name.fill(''),
    'no new name': () => inDialog('projects.cancel').click(),
    'a new name': () => list.renames('Den', 'Ant'),
    'it is hushed': () => child.presses('parts.close'),
    'a copy': () => list.chooses('Ant', 'duplicate'),
    'the copy goes': () => list.chooses(child.word('session.copy', { name: 'Ant' }), 'throw'),
    'it is taken back': () => child.presses('projects.takeBack'),
    'handed out in three ways, then thrown away again': async () => {
      const copy = child.word('session.copy', { name: 'Ant' })
      await saves(undefined, () => list.chooses(copy, 'saveFile'), /botgarten\.json$/)
      await saves(undefined, () => child.presses('projects.takeHome'), /\.json$/)
      await saves(undefined, () => child.presses('openRoberta.takeAll'), /\.zip$/)
      await list.chooses(copy, 'share')
      await expect(dialog).toBeVisible()
      await child.types('Escape')
      await list.chooses(copy, 'throw')
    },
    'a file that is no project': () => list.opensFile('a.json', 'hello'),
    'that is told': () => dialog.getByRole('button', { name: child.word('parts.ok') }).click(),
    'many projects': async () => {
      for (const file of ['A', 'B', 'C', 'D', 'E', 'F']) {
        await opensFile(file)
        await back()
      }
    },
    'a search that finds one': () => search.fill('ant'),
    'a search that finds none': () => search.fill('xyzzy'),
    'by name': async () => {
      await search.fill('')
      await page.getByRole('combobox', { name: child.word('projects.sort') }).selectOption('name')
    },
    'a damaged one': async () => {
      await breaks(page, 'Fox')
      await follows(child)
    },
    'its rest is saved, and it is thrown away': async () => {
      const tile = page.getByRole('article').filter({ hasText: child.word('projects.damagedText') })
      const press = (key: string) => tile.getByRole('button', { name: child.word(key) }).click()
      await saves(undefined, () => press('projects.saveFile'), /\.json$/)
      await press('projects.throw')
    },
    'the bin': () => list.goesToBin(),
    'the damaged one is saved and back': async () => {
      const one = list.inBin('Fox')
      await saves(undefined, () => one.getByRole('button', { name: child.word('projects.saveFile') }).click(), /\.json$/) // prettier-ignore
      await one.getByRole('button', { name: child.word('projects.takeBack') }).click()
    },
    'the copy is back': () => child.presses('projects.takeBack'),
    'a browser that asks': async () => {
      await promisesNothing(page)
      await page.locator('a[href$="/projects"]').last().click()
      await list.isSeen()
    },
    'it promises nothing': () => child.presses('projects.askLasting'),
  }
}

/** The list is read again. */
async function follows(child: Child) {
  await new ProjectList(child).goesToBin()
  await child.page.locator('a[href$="/projects"]').last().click()
  await new ProjectList(child).isSeen()
}

test('my projects, step by step', { tag: '@projects' }, async ({ child }) => {
  await goesThrough(child, 'projects', listSteps(child, new ProjectList(child)), {
    hides,
  })
})

test('a device that keeps nothing, step by step', { tag: '@projects' }, async ({ child, page }) => {
  await page.addInitScript(() => {
    const refuse = () => {
      throw new DOMException('Refused for a test.', 'SecurityError')
    }
    Object.defineProperty(IDBFactory.prototype, 'open', { value: refuse })
  })
  await goesThrough(child, 'projects-nowhere', {
    'nothing is kept': async () => {
      await new ProjectList(child).opens()
      await expect(page.getByText(child.word('projects.keptNowhere'))).toBeVisible()
    },
  })
})
