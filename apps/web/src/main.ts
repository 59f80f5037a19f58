import { mount } from 'svelte'
import App from './App.svelte'
import './look/page.css'
import { watchLooks } from './state/looks.svelte'

watchLooks()
mount(App, { target: document.getElementById('page')! })
