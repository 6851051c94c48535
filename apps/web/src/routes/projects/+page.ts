import { projects } from '#features/projects/feature.ts'
import { readSetting } from '#storage/settings.ts'
import { fetchWords } from '#words/message.ts'

export async function load() {
  // Work that an earlier version saved as a setting is listed as a project.
  if (readSetting('sorting', null))
    await import('#storage/old-sorting.ts').then((part) => part.moveOldSorting())
  await fetchWords(...projects.words)
}
