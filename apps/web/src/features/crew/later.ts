// What a child meets only when another robot is wanted.
export { default as AddRobot } from './AddRobot.svelte'
export { weightsFor, withBeside } from './beside.ts'
export { withoutRobot, withRobot } from './crew.ts'
export { default as CrewBar } from './CrewBar.svelte'
export { default as TwinMarks } from './TwinMarks.svelte'
export { default as TwinNote } from './TwinNote.svelte'
