// What a child meets only when another robot is wanted.
export { default as AddRobot } from './AddRobot.svelte'
export { withoutRobot, withRobot } from './crew.ts'
export { default as CrewBar } from './CrewBar.svelte'
