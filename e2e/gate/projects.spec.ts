import { ProjectList } from '../child-projects.ts'
import { leftEye, leftWheel } from '../child.ts'
import { freeProgram } from '../projects.ts'
import { expect, follows, link, opensCard, opensProject, test, title } from './gate.ts'

test.use({ language: 'de' })

test(
  'what was built is listed, gets a name and a copy, goes to the bin and comes back, and goes home as a file',
  {
    tag: ['@projects', '@/projects', '@/projects/bin'],
  },
  async ({ child, page }) => {
    const list = new ProjectList(child)
    await opensCard(child, 'friendship')
    await child.typesWeight(leftEye, leftWheel, 0.4)
    await child.seesSaved()
    await child.presses('lab.menu')
    await link(child, 'parts.myProjects').click()
    const card = child.card('friendship')
    await list.seesNames(card)
    await list.renames(card, 'Mein Bo')
    await list.chooses('Mein Bo', 'duplicate')
    const copy = child.word('session.copy', { name: 'Mein Bo' })
    await list.seesNames(copy, 'Mein Bo')
    await list.chooses(copy, 'throw')
    await list.hears('projects.thrown', { name: copy })
    await list.seesNames('Mein Bo')
    await page.getByRole('link', { name: child.word('projects.binCount', { count: 1 }) }).click()
    await expect(list.inBin(copy)).toContainText(child.word('projects.days', { days: 30 }))
    await child.presses('projects.takeBack')
    await expect(child.words('projects.binEmpty')).toBeVisible()
    await link(child, 'projects.toProjects').click()
    await list.seesNames(copy, 'Mein Bo')
    const home = JSON.parse(await list.takesHome()) as { projects: { project: { name: string } }[] }
    expect(home.projects.map(({ project }) => project.name).toSorted()).toEqual([copy, 'Mein Bo'].toSorted())
    await list.opensProject('Mein Bo')
    await child.seesWeight(leftEye, leftWheel, 0.4)
    const { name } = JSON.parse(await child.savesFile()) as { name: string }
    expect(name).toBe('Mein Bo')
  },
)

test(
  'a project becomes a link, and whoever opens the link has it as a project of its own',
  {
    tag: ['@share', '@/open'],
  },
  async ({ child, page }) => {
    await opensCard(child, 'friendship')
    await child.typesWeight(leftEye, leftWheel, 0.45)
    await child.seesSaved()
    await child.presses('lab.menu')
    await child.presses('parts.share')
    const address = await new ProjectList(child).link()
    await expect(page.getByRole('img', { name: child.word('share.code') })).toBeVisible()
    await child.types('Escape')
    await child.typesWeight(leftEye, leftWheel, 0.9)
    await child.seesSaved()
    await page.goto(address)
    await child.seesLab()
    await expect(page).not.toHaveURL(/#/)
    await child.seesWeight(leftEye, leftWheel, 0.45)
    await follows(child, 'parts.myProjects')
    await expect.poll(() => new ProjectList(child).names()).toHaveLength(2)
    await page.goto(`/open#${address.split('#')[1]!.slice(0, 40)}`)
    await expect(title(page)).toHaveText(child.word('problem.linkCut.title'))
  },
)

test(
  'text for a robot follows the blocks, lights up with them, and is saved as it is shown',
  {
    tag: '@python',
  },
  async ({ child, page }) => {
    const steps = freeProgram('Schritte', (make) => [make.wait(100), make.wait(200), make.wait(300)])
    await opensProject(child, 'Schritte', steps)
    await child.presses('lab.code')
    const line = (text: string) => page.getByRole('option').filter({ hasText: text })
    await expect(line('wait(200)')).toBeVisible()
    await child.block('b4').click({ position: { x: 28, y: 20 } })
    await expect(line('wait(200)')).toHaveAttribute('aria-selected', 'true')
    await child.typesNumber('b3', '450')
    await expect(line('wait(450)')).toBeVisible()
    await expect(line('wait(200)')).toHaveCount(0)
    await page.getByRole('button', { name: child.word('python.library.ev3dev2') }).click()
    await expect(line('sleep(0.45)')).toBeVisible()
    const [file] = await Promise.all([
      page.waitForEvent('download'),
      page.getByRole('button', { name: /\.py/ }).click(),
    ])
    expect(file.suggestedFilename()).toMatch(/\.py$/)
  },
)
