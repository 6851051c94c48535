import { ProjectList } from '../child-projects.ts'
import { freeProgram } from '../projects.ts'
import { expect, follows, opensCard, opensProject, test } from '../gate/gate.ts'
import { goesThrough } from '../steps.ts'

test.use({ language: 'en' })

/** When a project was changed, and its id. */
const hides = /(^|(?<=[ "]))(now|\d+ \w+ ago)(?="|$| )|(?<=[?&]p=)[\w-]+/g

test('the page where all begins, step by step', { tag: '@home' }, async ({ child, page }) => {
  const dialog = page.getByRole('dialog')
  await goesThrough(
    child,
    'home',
    {
      'nobody has been here': () => child.opensHome(),
      'what is learned from examples': () => child.presses('home.fromExamples'),
      'what is learned by trying': () => child.presses('home.byTrying'),
      'what is set by hand': () => child.presses('home.byHand'),
      'a new project': () => page.getByRole('button', { name: child.word('home.free') }).click(),
      'none after all': () =>
        dialog.getByRole('button', { name: child.word('projects.cancel'), exact: true }).click(),
      'a solved card': async () => {
        await opensCard(child, 'forward')
        await child.typesNumber('driveDistance', '170')
        await child.pressesStart()
        await child.seesCheck('forward', 'arrives')
        await child.seesSaved()
        await child.opensHome()
      },
      'projects besides': async () => {
        for (const name of ['Ant', 'Bee'])
          await opensProject(
            child,
            name,
            freeProgram(name, (make) => [make.wait(1)]),
          )
        await child.opensHome()
      },
      'the last project goes on': async () => {
        await page.getByRole('link', { name: child.word('home.continue', { name: 'Bee' }) }).click()
        await expect(page.getByRole('heading', { level: 1 })).toHaveText('Bee')
        await follows(child, 'parts.myProjects')
        await new ProjectList(child).isSeen()
      },
      'a narrow window': async () => {
        await page.setViewportSize({ width: 390, height: 844 })
        await child.opensHome()
      },
    },
    { hides },
  )
})
