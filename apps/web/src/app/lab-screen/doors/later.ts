// Doors out of a project, and into another one: each is asked for by a click.
export {
  foreignDifferences,
  keepCopy,
  keepGone,
  loadNewer,
  openFile,
  saveForOpenRoberta,
  sortingDoors,
} from './doors.ts'
