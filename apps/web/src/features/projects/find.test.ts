import type { Project } from '@botgarten/programs'
import { expect, test } from 'vitest'
import type { Listed } from '#storage/projects.ts'
import { findProjects } from './find.ts'

const kept = (name: string, changed: number): Listed => ({
  ...{ id: name, changed },
  project: { name } as Project,
})
const all = [kept('Möwe 10', 3), kept('möwe 9', 2), kept('Rallye', 1)]
const names = (words: string, order: 'time' | 'name' = 'time') =>
  findProjects(all, { words, order, locale: 'de' }, ({ project }) => project.name).map(({ id }) => id)

test('no words find everything, as it was kept', () =>
  expect(names('  ')).toEqual(['Möwe 10', 'möwe 9', 'Rallye']))

test('capitals and dots on letters do not matter', () => {
  expect(names('MOWE')).toEqual(['Möwe 10', 'möwe 9'])
  expect(names('möwe 1')).toEqual(['Möwe 10'])
  expect(names('zebra')).toEqual([])
})

test('by name, numbers are counted as numbers', () =>
  expect(names('', 'name')).toEqual(['möwe 9', 'Möwe 10', 'Rallye']))
